// How a bridge, or the page, waits for its link without blocking: what else comes must come in meanwhile.

import { BusParticipant } from '../../protocol/generated/constants.ts';
import type { BridgeLink } from './bridge.ts';

/** Without Atomics.waitAsync, and while something is to be tried again, ms. */
const lookMs = 5;

type WaitAsync = (
  words: Int32Array,
  index: number,
  value: number,
  timeoutMs?: number,
) => { readonly async: boolean; readonly value: PromiseLike<string> | string; };

function pause(): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, lookMs);
  });
}

/** Resolves at the next event of the participant after `token`; with `soon` not much later than now. */
export async function nextEvent(link: BridgeLink, token: number, soon: boolean): Promise<void> {
  if (link.kind === 'port') {
    await link.wait(token, soon ? lookMs : -1);
    return;
  }
  const { bus, participant } = link;
  const { waitAsync } = Atomics as { waitAsync?: WaitAsync; };
  if (waitAsync === undefined) return await pause();
  const word = bus.participantWord(participant);
  bus.add(word + BusParticipant.sleepers, 1);
  try {
    const { async, value } = waitAsync(bus.i32, word + BusParticipant.wake, token, soon ? lookMs : undefined);
    // An event that came at once: what the channel brought must come in too.
    if (async) await value;
    else await turn();
  } finally {
    bus.sub(word + BusParticipant.sleepers, 1);
  }
}

/** One turn of the event loop, without the clamping of timers. */
export function turn(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(0);
  });
}
