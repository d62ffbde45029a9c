// The session of a page whose site has tasks: it reports to the tasks when the visitor acts on the site. Looking does not
// count as an act: subscriptions, requests that change nothing, the time's controls. Actions that the visitor did not ask for,
// such as a bag that plays by itself, go through `unattended`.

import type { PageActionClient, PageClient, PageNode, PagePublisher } from '../contract/page_node.ts';
import type { NotebookKernel, Session, Sources } from '../contract/session.ts';

/** Members of a session that act whenever they are called. */
const acts = new Set<string | symbol>(['start', 'stop', 'restart', 'run', 'launch', 'startAll', 'stopAll', 'restartAll', 'interrupt', 'sendInput']);

/** Services that only read; panels call them without the visitor. */
const telling = new Set([
  'rcl_interfaces/srv/GetParameters',
  'rcl_interfaces/srv/ListParameters',
  'rcl_interfaces/srv/DescribeParameters',
  'rcl_interfaces/srv/GetParameterTypes',
  'rcl_interfaces/srv/GetLoggerLevels',
  'lifecycle_msgs/srv/GetState',
  'lifecycle_msgs/srv/GetAvailableStates',
  'lifecycle_msgs/srv/GetAvailableTransitions',
  'composition_interfaces/srv/ListNodes',
  'type_description_interfaces/srv/GetTypeDescription',
]);

type Methods = Readonly<Record<string | symbol, unknown>>;

/** `target` with some members in place of its own; its methods keep it as `this`. */
function overlaid<T extends object>(target: T, own: Partial<T>): T {
  const bound = new Map<string | symbol, unknown>();
  return new Proxy(target, {
    get(_target, key) {
      if (Object.hasOwn(own, key)) return (own as Methods)[key];
      const value = (target as Methods)[key];
      if (typeof value !== 'function') return value;
      // The same function each time, as effects of the page compare them.
      if (!bound.has(key)) bound.set(key, (value as (...values: unknown[]) => unknown).bind(target));
      return bound.get(key);
    },
  });
}

export function actingSession(session: Session): Session {
  const { tasks } = session;
  if (tasks === undefined) return session;
  const acted = (): void => tasks.acted();
  const own: Record<string | symbol, unknown> = {};
  for (const key of acts) {
    const method = (session as unknown as Methods)[key] as (...values: unknown[]) => unknown;
    own[key] = (...values: unknown[]) => {
      acted();
      return method.apply(session, values);
    };
  }
  let node: PageNode | undefined;
  own['node'] = () => (node ??= actingNode(session.node(), acted));
  if (session.sources !== undefined) own['sources'] = actingSources(session.sources, acted);
  if (session.notebook !== undefined) own['notebook'] = actingNotebook(session.notebook, acted);
  own['unattended'] = session;
  return overlaid(session, own as Partial<Session>);
}

function actingNode(node: PageNode, acted: () => void): PageNode {
  return overlaid<PageNode>(node, {
    publisher: (...values) => {
      const publisher = node.publisher(...values);
      return overlaid<PagePublisher>(publisher, {
        publish: (bytes) => {
          acted();
          return publisher.publish(bytes);
        },
      });
    },
    client: (service, type) => {
      const client = node.client(service, type);
      if (telling.has(type)) return client;
      return overlaid<PageClient>(client, {
        call: (...values) => {
          acted();
          return client.call(...values);
        },
      });
    },
    actionClient: (action, type) => {
      const client = node.actionClient(action, type);
      return overlaid<PageActionClient>(client, {
        sendGoal: (...values) => {
          acted();
          return client.sendGoal(...values);
        },
      });
    },
  });
}

function actingSources(sources: Sources, acted: () => void): Sources {
  return overlaid(sources, {
    change: (path, text) => {
      acted();
      return sources.change(path, text);
    },
  });
}

function actingNotebook(notebook: NotebookKernel, acted: () => void): NotebookKernel {
  return overlaid(notebook, {
    send: (order) => {
      acted();
      notebook.send(order);
    },
  });
}
