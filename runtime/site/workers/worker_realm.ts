// The APIs that are removed from the worker of a node before anything of a site runs in it. Sites of one origin share the
// browser's storage and its channels between pages: a node that had them could change other sites, now or at later visits. A
// worker that cannot start another worker has no other realm from which to take them.

interface Taken {
  /** Names in the global scope, and in `navigator`; a name that a browser does not have needs no removal. */
  readonly scope?: readonly string[];
  readonly navigator?: readonly string[];
  readonly why: string;
}

export const taken: readonly Taken[] = [
  {
    scope: ['caches', 'Cache', 'CacheStorage'],
    why: 'what is cached there is what other sites of the origin are offline',
  },
  {
    scope: [
      'indexedDB',
      'IDBFactory',
      'IDBDatabase',
      'IDBObjectStore',
      'IDBTransaction',
      'IDBIndex',
      'IDBCursor',
      'IDBCursorWithValue',
      'IDBKeyRange',
      'IDBOpenDBRequest',
      'IDBRequest',
      'IDBVersionChangeEvent',
      'IDBRecord',
    ],
    why: 'notebooks of visitors are stored there',
  },
  {
    scope: ['StorageManager', 'StorageBucket', 'StorageBucketManager'],
    navigator: ['storage', 'storageBuckets', 'webkitTemporaryStorage', 'webkitPersistentStorage'],
    why: 'they lead to caches, databases and files of the origin',
  },
  {
    scope: [
      'webkitRequestFileSystem',
      'webkitRequestFileSystemSync',
      'webkitResolveLocalFileSystemURL',
      'webkitResolveLocalFileSystemSyncURL',
      'FileSystemHandle',
      'FileSystemFileHandle',
      'FileSystemDirectoryHandle',
      'FileSystemSyncAccessHandle',
      'FileSystemWritableFileStream',
      'FileSystemObserver',
    ],
    why: 'files of the origin; a node has its own, in memory',
  },
  {
    scope: ['cookieStore', 'CookieStore', 'CookieStoreManager', 'sharedStorage', 'SharedStorage', 'localStorage', 'sessionStorage'],
    why: 'further storage of the origin, in browsers that give it to workers',
  },
  {
    scope: ['Worker', 'SharedWorker', 'ShadowRealm'],
    why: 'another realm would have all of this again; threads are started by the page',
  },
  {
    scope: ['ServiceWorker', 'ServiceWorkerContainer', 'ServiceWorkerRegistration', 'NavigationPreloadManager', 'PushManager', 'SyncManager',
      'PeriodicSyncManager', 'BackgroundFetchManager'],
    navigator: ['serviceWorker'],
    why: 'a service worker answers in the place of the host',
  },
  {
    scope: ['BroadcastChannel'],
    why: 'a way into open pages of other sites of the origin, such as the graph that tabs share',
  },
  {
    scope: ['Lock', 'LockManager'],
    navigator: ['locks'],
    why: 'locks tell pages that a worker or a tab is over; a node could hold those of others',
  },
  {
    scope: ['WebSocket', 'WebSocketStream', 'WebTransport', 'EventSource', 'RTCPeerConnection', 'RTCDataChannel'],
    why: 'connections that stay open past a request; the policy of the site allows them to the own host at most',
  },
  {
    scope: ['HID', 'HIDDevice', 'Serial', 'SerialPort', 'USB', 'USBDevice'],
    navigator: ['hid', 'serial', 'usb', 'bluetooth'],
    why: 'devices that the visitor has allowed to another site of the origin',
  },
  {
    scope: ['Notification', 'IdleDetector'],
    why: 'notices and observation of the visitor that another site of the origin was allowed',
  },
  {
    scope: ['close'],
    why: 'a worker that ends itself does not report it: the page would show a running node',
  },
];

/** The removed functions that ros2wasm's own code needs before anything of the site runs. */
export interface KeptDoors {
  /** Scripts of the site. Pyodide finds out where it runs by there being such a function. */
  readonly importScripts: (...addresses: string[]) => void;
  readonly locks: LockManager | undefined;
  readonly openChannel: ((name: string) => BroadcastChannel) | undefined;
}

/** Wherever on the prototype chain it is. Throws in a browser that does not let it go: no node may run there. */
function takeFrom(object: object, name: string): void {
  for (let at: object | null = object; at !== null; at = Object.getPrototypeOf(at) as object | null) {
    if (Object.hasOwn(at, name) && !Reflect.deleteProperty(at, name)) throw new Error(`this browser does not let a worker do without ${name}`);
  }
}

/** Takes it all from the worker whose scope that is. To be called once, before anything else runs. */
export function closeRealm(scope: DedicatedWorkerGlobalScope): KeptDoors {
  const { navigator } = scope;
  const Channel = (scope as { BroadcastChannel?: typeof BroadcastChannel; }).BroadcastChannel;
  const doors: KeptDoors = {
    importScripts: scope.importScripts.bind(scope),
    locks: (navigator as { locks?: LockManager; }).locks,
    openChannel: Channel === undefined ? undefined : (name) => new Channel(name),
  };
  for (const { scope: ofScope = [], navigator: ofNavigator = [] } of taken) {
    for (const name of ofScope) takeFrom(scope, name);
    for (const name of ofNavigator) takeFrom(navigator, name);
  }
  takeFrom(scope, 'importScripts');
  Object.defineProperty(scope, 'importScripts', {
    value: () => {
      throw new Error('a node cannot load scripts');
    },
  });
  return doors;
}
