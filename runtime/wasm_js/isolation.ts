// Cross-origin isolation, which shared memory needs: given by the host's headers, or else by our service worker, which
// adds them; the page then loads once more. Also asks the service worker to keep the site for use without a network.

const marker = 'ros2wasm-isolation-tried';
const takeoverMs = 4000;

/** Storage is refused in some frames; then there is no second try either. */
function remember(value: string | undefined): string | null | undefined {
  try {
    const old = sessionStorage.getItem(marker);
    if (value === undefined) sessionStorage.removeItem(marker);
    else sessionStorage.setItem(marker, value);
    return old;
  } catch {
    return undefined;
  }
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
    remember(undefined);
    return 'yes';
  }
  const container = serviceWorkers();
  // A frame in a foreign page is isolated only when that page is.
  if (container === undefined || window.top !== window.self) return 'no';
  if (remember('tried') !== null) {
    remember(undefined);
    return 'no';
  }
  try {
    const registration = await container.register(script, { updateViaCache: 'none' });
    if ((registration?.installing ?? registration?.waiting ?? registration?.active ?? null) === null) return 'no';
    if (!await controlled(container)) return 'no';
  } catch {
    return 'no';
  }
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

/** Keeps the site for later visits without a network. Failing is no fault: the site runs all the same. */
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
