// Starts a site in a browser page.

import { type Broker, PortBroker, SharedBroker, type SharedBrokerOptions, steppedBus } from '../bus/broker.ts';
import { browserPlatform } from './browser_platform.ts';
import { carriedFiles } from '../program/carried_files.ts';
import { earlierPack } from '../program/earlier_pack.ts';
import { whenIdle } from '../contract/idle.ts';
import { isolate, keepOffline } from './isolation.ts';
import { givenInAddress } from '../contract/launch_arguments.ts';
import { namedNodes } from '../launch/named_nodes.ts';
import { promiseIntegration } from '../program/program.ts';
import type { CommandLoader, LinkKind, Session } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import { readSite } from '../contract/site_reader.ts';
import { type SessionOptions, SiteSession } from './site_session.ts';
import { SteppedTime } from '../bus/stepped_time.ts';

export interface LaunchOptions {
  /** Where site.json lies; the page's own folder when omitted. */
  readonly base?: URL;
  /** For tests: use this link though the other would do. */
  readonly link?: LinkKind;
  /** For launch files that start commands of `ros2`. */
  readonly commands?: CommandLoader;
  /** Called when the site is kept for visits without a network, or cannot be. */
  readonly onOffline?: (kept: boolean) => void;
}

const longestWaitMs = 250;
/** Upper bound in ms on how long nodes may boot before the site is cached for offline visits anyway. */
const longestBootMs = 10_000;

const ceilings = [1 << 30, 512 << 20, 256 << 20, 128 << 20];

/** A bus as large as the machine allows, or undefined. */
function sharedBroker(options: SharedBrokerOptions = {}): SharedBroker | undefined {
  if (typeof SharedArrayBuffer === 'undefined') return undefined;
  for (const ceiling of ceilings) {
    try {
      return new SharedBroker({ ...options, ceiling });
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
    }
  }
  return undefined;
}

/** What `?seed=` of the page's address asks for. */
function steppedOptions(text: string): Pick<SessionOptions, 'broker' | 'stepped'> {
  if (!/^\d{1,9}$/.test(text)) {
    throw new SiteError('R2W0711', `the address asks for a stepped run with the seed \`${text}\``, {
      why: 'a seed is a whole number below 1,000,000,000',
      fix: 'correct `seed=` in the address, or leave it out to start the site as it was made',
    });
  }
  const seed = Number(text);
  const broker = sharedBroker(steppedBus(seed));
  if (broker?.conductor === undefined) {
    throw new SiteError('R2W0711', 'this page has no shared memory, which a stepped run needs', {
      why: 'the messages on their way in a message port cannot be counted',
      fix: 'open the page in a tab of its own over https:// or localhost, or leave out `seed=`',
    });
  }
  return { broker, stepped: { seed, time: new SteppedTime(broker, broker.conductor) } };
}

function chooseBroker(wanted: LinkKind | undefined): Broker {
  const shared = wanted === 'port' ? undefined : sharedBroker();
  if (shared !== undefined) return shared;
  if (promiseIntegration() !== undefined) return new PortBroker();
  throw new SiteError('R2W0705', 'this page can neither share memory between nodes nor suspend a node that waits', {
    why: 'it is shown inside another page, or this browser is too old',
    fix: 'open the page in a tab of its own, in a current browser',
  });
}

/**
 * Resolves when every node has made what it makes and waits. Drawing the page holds up the thread that starts the
 * workers and takes a core from them, so it comes after them, but not long after: a slow network or a node that
 * computes does not keep the page away.
 */
function underWay(session: SiteSession, longestMs: number): Promise<void> {
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, longestMs);
    void session.settled.then(() => {
      clearTimeout(timer);
      resolve();
    });
  });
}

/** As the address says (`#autorun=0` or `1`), else the manifest. */
function startsByItself(site: Pick<Session['site'], 'ui'>): boolean {
  const asked = new URLSearchParams(location.hash.slice(1)).get('autorun');
  return asked === '0' ? false : asked === '1' || site.ui['autostart'] !== false;
}

/** Never resolves when the page reloads to become isolated. Rejects with a SiteError. */
export async function startSession(options: LaunchOptions = {}): Promise<Session> {
  const base = options.base ?? new URL('./', document.baseURI);
  const serviceWorker = new URL('service_worker.js', base);
  // A page that carries its files has no service worker beside it.
  const alone = carriedFiles() !== undefined;
  if (options.link === undefined && !alone) {
    const isolation = await isolate(serviceWorker);
    if (isolation === 'reloading') return new Promise(() => undefined);
  }
  const platform = browserPlatform(base, 'node_worker.js', document.documentElement.dataset['worker']);
  const packed = readSite(await platform.json('site.json'));
  if (packed.stored === true) {
    const earlier = await earlierPack(base, location.hash);
    if (earlier !== undefined) {
      location.replace(new URL(location.search + location.hash, earlier));
      return new Promise(() => undefined);
    }
  }
  platform.expect(packed.files);
  const given = givenInAddress(location.search);
  const begun = performance.now();
  const site = given.size === 0 ? packed : await (await import('../launch/launch_evaluation.ts')).siteWithArguments(packed, given, platform);
  // For the browser's own tools, and `./dev bench launch`.
  if (given.size > 0) performance.measure('ros2wasm: launch arguments', { start: begun });
  await platform.ready;
  const asked = new URLSearchParams(location.search);
  const nodes = asked.get('nodes');
  // Before anything is begun that would have to be ended.
  const named = nodes === null ? undefined : namedNodes(nodes, site.nodes.map(({ id }) => id));
  const seed = asked.get('seed');
  const run = seed === null ? { broker: chooseBroker(options.link) } : steppedOptions(seed);
  const commands = options.commands === undefined ? {} : { commands: options.commands };
  const session = new SiteSession({ site, platform, ...run, ...commands });
  const graph = asked.get('graph');
  if (graph !== null && graph !== '') await session.joinTabs(graph);
  // Before the first node starts, so that all that it says is seen. Fetched only for a site that has some.
  if (site.checks.length > 0) session.useChecks(await (await import('../checks/check_run.ts')).runChecks(session));
  const acting = site.tasks.length === 0 ? session : await withTasks(session);
  performance.mark('ros2wasm: nodes are told to start');
  let booted = Promise.resolve();
  if (named !== undefined) {
    for (const id of named) session.start(id);
  } else if (startsByItself(site)) {
    await session.startUnclaimed();
    booted = underWay(session, longestBootMs);
    await underWay(session, longestWaitMs);
  }
  // Styles and tests can tell by <html data-offline> whether the site is kept.
  const later = (): void =>
    void (alone ? Promise.resolve(true) : keepOffline(serviceWorker)).then((kept) => {
      document.documentElement.dataset['offline'] = kept ? 'kept' : 'not_kept';
      options.onOffline?.(kept);
    });
  // Nodes that boot an interpreter need the cores more; one that computes for ever does not keep the site from being kept.
  void booted.then(() => whenIdle(later));
  window.addEventListener('pagehide', (event) => {
    if (!event.persisted) session.close();
  });
  return acting;
}

/** The visitor's actions in the returned session count for the tasks; those of the launch do not. */
async function withTasks(session: SiteSession): Promise<Session> {
  const [{ runTasks }, { actingSession }] = await Promise.all([import('../checks/task_run.ts'), import('../checks/acting_session.ts')]);
  session.useTasks(await runTasks(session));
  return actingSession(session);
}
