// Cross-origin isolation, which shared memory needs: given by the host's headers, or else by our service worker, which
// adds them; the page then loads once more. Also asks the service worker to keep the site for use without a network.

const takeoverMs = 4000;

/**
 * The reload is noted in the entry of the page's history: that belongs to this address in this tab, and the browser hands it to the
 * process that has the page. Storage of the tab would be that of all sites of the origin, of which another process may have an old copy.
 */
const mark = 'ros2wasm reloads to be isolated';

function hasReloaded(): boolean {
  const [entry] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[];
  // A copy of the tab has the note too, but was not reloaded.
  return isMarked(history.state) && (entry === undefined || entry.type === 'reload');
}

function isMarked(state: unknown): boolean {
  return typeof state === 'object' && state !== null && mark in state;
}

/** False: it cannot be noted, so that the page might reload for ever. */
function remember(): boolean {
  const state: unknown = history.state;
  try {
    history.replaceState({ ...(typeof state === 'object' ? state : {}), [mark]: true }, '');
    return isMarked(history.state);
  } catch {
    return false;
  }
}

/** A reload by the visitor is a new try. */
function forget(): void {
  const state: unknown = history.state;
  if (!isMarked(state)) return;
  const { [mark]: _marked, ...rest } = state as Record<string, unknown>;
  history.replaceState(Object.keys(rest).length === 0 ? null : rest, '');
}

function serviceWorkers(): ServiceWorkerContainer | undefined {
  try {
    return isSecureContext && 'serviceWorker' in navigator ? navigator.serviceWorker : undefined;
  } catch {
    return undefined;
  }
}

function controlled(container: ServiceWorkerContainer): Promise<boolean> {
  if (container.controller !== null) return Promise.resolve(true);
  return new Promise((resolve) => {
    const timer = setTimeout(() => resolve(false), takeoverMs);
    container.addEventListener('controllerchange', () => {
      clearTimeout(timer);
      resolve(true);
    }, { once: true });
  });
}

/**
 * 'yes': the page may share memory. 'reloading': it will, after the reload that has begun. 'no': it cannot here.
 */
export async function isolate(script: URL): Promise<'yes' | 'no' | 'reloading'> {
  if (globalThis.crossOriginIsolated) {
    forget();
    return 'yes';
  }
  const container = serviceWorkers();
  // A frame in a foreign page is isolated only when that page is.
  if (container === undefined || window.top !== window.self) return 'no';
  if (hasReloaded()) {
    forget();
    return 'no';
  }
  try {
    const registration = await container.register(script, { updateViaCache: 'none' });
    if ((registration?.installing ?? registration?.waiting ?? registration?.active ?? null) === null) return 'no';
    if (!await controlled(container)) return 'no';
  } catch {
    return 'no';
  }
  if (!remember()) return 'no';
  location.reload();
  return 'reloading';
}

/** The worker that answers for the page; undefined when it could not be installed, of which `container.ready` never tells. */
function activated(registration: ServiceWorkerRegistration): Promise<ServiceWorker | undefined> {
  const { active, waiting, installing } = registration;
  const worker = active ?? waiting ?? installing;
  if (worker === null) return Promise.resolve(undefined);
  return new Promise((resolve) => {
    const look = (): void => {
      if (worker.state === 'activated') resolve(worker);
      else if (worker.state === 'redundant') resolve(undefined);
    };
    worker.addEventListener('statechange', look);
    look();
  });
}

/** Keeps the site for later visits without a network. Failing is not a fault: the site runs all the same. */
export async function keepOffline(script: URL): Promise<boolean> {
  const container = serviceWorkers();
  if (container === undefined) return false;
  try {
    const active = await activated(await container.register(script, { updateViaCache: 'none' }));
    if (active === undefined) return false;
    const channel = new MessageChannel();
    const done = new Promise<boolean>((resolve) => {
      channel.port1.onmessage = (event: MessageEvent<unknown>) => resolve(event.data === 'kept');
    });
    active.postMessage('keep', [channel.port2]);
    return await done;
  } catch {
    return false;
  }
}
