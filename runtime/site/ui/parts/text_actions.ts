// The actions of a lab sheet's links on the graph: publish, set a parameter, call a service, send a goal, evaluate checks
// again. Each reports its progress in words.

import type { CheckView, PagePublisher, Session } from '../../contract/session.ts';
import { toYaml } from '../../decode/yaml.ts';
import type { Codec } from '../../decode/codec.ts';
import { endpointsToCall } from '../model/callable.ts';
import { draftBytes, refusal } from '../model/draft_value.ts';
import type { PageAction } from '../model/page_action.ts';
import { problemOf } from '../model/problem.ts';
import { panelTexts } from '../texts_panels.ts';
import { textActionTexts } from '../texts_text_actions.ts';
import { matched } from './matched.ts';
import { codecOf } from './message_feed.ts';

export type GraphAction = Extract<PageAction, { readonly kind: 'publish' | 'set_param' | 'call' | 'goal' | 'check'; }>;

/** Upper bound of the characters of an answer that is shown beside the text. */
const MOST_ANSWER = 2000;

export class TextActions {
  private readonly session: Session;
  private readonly say: (text: string) => void;
  private readonly publishers = new Map<string, PagePublisher>();
  private readonly leaving = new AbortController();
  private stopChecks: () => void = () => undefined;
  /** The number of the last action: the progress of earlier ones is no longer reported. */
  private newest = 0;

  constructor(session: Session, say: (text: string) => void) {
    this.session = session;
    this.say = say;
  }

  act(action: GraphAction): void {
    this.newest += 1;
    const own = this.newest;
    const say = (text: string): void => {
      if (own === this.newest && !this.leaving.signal.aborted) this.say(text);
    };
    this.stopChecks();
    this.done(action, say).then(say, (error: unknown) => say(panelTexts.text.failed(problemOf(error).what)));
  }

  close(): void {
    this.leaving.abort();
    this.stopChecks();
    for (const publisher of this.publishers.values()) publisher.close();
  }

  private done(action: GraphAction, say: (text: string) => void): Promise<string> {
    switch (action.kind) {
      case 'publish':
        return this.publish(action.topic, action.type, action.value);
      case 'set_param':
        return this.setParam(action.node, action.name, action.value);
      case 'call':
        return this.call(action.name, action.type, action.value, say);
      case 'goal':
        return this.goal(action.name, action.type, action.value, say);
      case 'check':
        return Promise.resolve(this.check(action.name, say));
    }
  }

  private async publish(topic: string, type: string, value: string): Promise<string> {
    const codec = await codecOf(this.session);
    const bytes = await this.written(codec, type, value);
    const key = `${topic} ${type}`;
    const publisher = this.publishers.get(key) ?? this.session.node().publisher(topic, type);
    this.publishers.set(key, publisher);
    if (publisher.problem !== undefined) {
      this.publishers.delete(key);
      throw publisher.problem;
    }
    await matched(publisher);
    const problem = publisher.publish(bytes);
    return problem === undefined ? panelTexts.text.published(topic) : panelTexts.text.failed(problem.message);
  }

  private async setParam(node: string, name: string, value: string): Promise<string> {
    const { session } = this;
    const { setText } = await import('../../ros2cli/parameter_calls.ts');
    const caller = { session, codec: () => codecOf(session), signal: this.leaving.signal };
    const full = node.startsWith('/') ? node : `/${node}`;
    const { successful, reason } = await setText(caller, full, name, value);
    return successful ? panelTexts.text.set(name, full) : panelTexts.text.refused(full, reason);
  }

  private async call(name: string, given: string, value: string, say: (text: string) => void): Promise<string> {
    const type = this.typeOf('service', name, given);
    const codec = await codecOf(this.session);
    const request = await this.written(codec, `${type}_Request`, value);
    say(textActionTexts.calling(name));
    const client = this.session.node().client(name, type);
    try {
      const reply = await client.call(request, { signal: this.leaving.signal });
      return textActionTexts.replied(name, asText(codec, `${type}_Response`, reply));
    } finally {
      client.close();
    }
  }

  private async goal(name: string, given: string, value: string, say: (text: string) => void): Promise<string> {
    const type = this.typeOf('action', name, given);
    const codec = await codecOf(this.session);
    const goal = await this.written(codec, `${type}_Goal`, value);
    const client = this.session.node().actionClient(name, type);
    const end = (): void => client.close();
    this.leaving.signal.addEventListener('abort', end);
    try {
      say(textActionTexts.goal(name, 'unknown'));
      const sent = client.sendGoal(goal, { onStatus: (status) => say(textActionTexts.goal(name, status)) });
      // Its refusal is that of the result, too.
      sent.accepted.catch(() => undefined);
      const { status, bytes } = await sent.result;
      return textActionTexts.result(name, status, asText(codec, `${type}_GetResult_Response`, bytes));
    } finally {
      this.leaving.signal.removeEventListener('abort', end);
      client.close();
    }
  }

  /** Looks again, and says what is decided. */
  private check(name: string, say: (text: string) => void): string {
    const { checks } = this.session;
    const at = checks?.views().findIndex(({ title }) => title === name) ?? -1;
    if (checks === undefined || (name !== '' && at === -1)) return textActionTexts.noCheck(name);
    if (name === '') checks.again();
    else checks.again(at);
    const words = (views: readonly CheckView[]): string => textActionTexts.checks(name === '' ? views : views.slice(at, at + 1));
    this.stopChecks = checks.onChange((views) => say(words(views)));
    return words(checks.views());
  }

  private typeOf(kind: 'service' | 'action', name: string, given: string): string {
    if (given !== '') return given;
    const found = endpointsToCall(this.session.graph(), true).find((each) => each.kind === kind && each.name === name);
    if (found === undefined) throw new Error(textActionTexts.nobody(name));
    return found.type;
  }

  private async written(codec: Codec, type: string, value: string): Promise<Uint8Array<ArrayBuffer>> {
    const made = await draftBytes(codec, type, { view: 'yaml', text: value }, this.session.time.view().now);
    if (made.kind === 'failed') throw new Error(refusal(made));
    return made.bytes;
  }
}

function asText(codec: Codec, type: string, bytes: Uint8Array): string {
  const read = codec.decode(type, bytes);
  return read.kind === 'failed' ? read.reason : toYaml(read.value, read.shape).trim().slice(0, MOST_ANSWER);
}
