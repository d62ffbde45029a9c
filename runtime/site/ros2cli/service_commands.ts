// ros2 service list, type, find, info, call.

import { expandName, fullTypeName } from '../decode/ros_names.ts';
import { callService } from './calls.ts';
import { type Command, CommandError, has, untilDone } from './command.ts';
import { decoded, fillMessage } from './filled_message.ts';
import { endpointsOf, named, servicesOf, shown } from './graph_lists.ts';
import { reprMessage } from './python_text.ts';

const hidden = { names: ['--include-hidden-services'], help: 'Consider hidden services as well' } as const;

export const serviceCommands: readonly Command[] = [
  {
    words: ['service', 'list'],
    help: 'Output a list of available services',
    positionals: [],
    options: [
      { names: ['--show-types', '-t'], help: 'Additionally show the service type' },
      { names: ['--count-services', '-c'], help: 'Only display the number of services discovered' },
      hidden,
    ],
    run: (context, given) => {
      const services = shown(servicesOf(context.session.graph()), has(given, 'include-hidden-services'));
      if (has(given, 'count-services')) context.print(String(services.length));
      else for (const { name, types } of services) context.print(has(given, 'show-types') ? `${name} [${types.join(', ')}]` : name);
      return Promise.resolve(0);
    },
  },
  {
    words: ['service', 'type'],
    help: "Output a service's type",
    positionals: [{ name: 'service_name', meaning: 'service' }],
    options: [],
    run: (context, given) => {
      const service = servicesOf(context.session.graph()).find(({ name }) => name === given.positionals[0]);
      for (const type of service?.types ?? []) context.print(type);
      return Promise.resolve(service === undefined ? 1 : 0);
    },
  },
  {
    words: ['service', 'find'],
    help: 'Output a list of available services of a given type',
    positionals: [{ name: 'service_type', meaning: 'service_type' }],
    options: [{ names: ['--count-services', '-c'], help: 'Only display the number of services discovered' }, hidden],
    run: (context, given) => {
      const found = shown(servicesOf(context.session.graph()), has(given, 'include-hidden-services')).filter(({ types }) =>
        types.includes(given.positionals[0]!)
      );
      if (has(given, 'count-services')) context.print(String(found.length));
      else for (const { name } of found) context.print(name);
      return Promise.resolve(0);
    },
  },
  {
    words: ['service', 'info'],
    help: 'Print information about a service',
    positionals: [{ name: 'service_name', meaning: 'service' }],
    options: [],
    run: (context, given) => {
      const [name = ''] = given.positionals;
      const graph = context.session.graph();
      const [servers, clients] = [endpointsOf(graph, 'services', name), endpointsOf(graph, 'clients', name)];
      const [service] = named([...servers, ...clients].map(({ endpoint }) => endpoint));
      if (service === undefined) throw new CommandError(`Unknown service '${name}'`);
      context.print(`Type: ${service.types.join(', ')}\nClients count: ${clients.length}\nServices count: ${servers.length}`);
      return Promise.resolve(0);
    },
  },
  {
    words: ['service', 'call'],
    help: 'Call a service',
    positionals: [
      { name: 'service_name', meaning: 'service' },
      { name: 'service_type', meaning: 'service_type' },
      { name: 'values', meaning: 'service_values', optional: true },
    ],
    options: [{ names: ['--rate', '-r'], value: 'N', number: true, help: 'Repeat the call at a specific rate in Hz' }],
    run: async (context, given) => {
      const [service = '', typed = '', yaml] = given.positionals;
      const name = expandName(service, '');
      const type = fullTypeName(typed, 'srv');
      if (type === undefined) throw new CommandError('The passed service type is invalid');
      const codec = await context.codec();
      const call = async (): Promise<void> => {
        const request = await fillMessage(codec, `${type}_Request`, yaml, context.session.time.view().now);
        if (endpointsOf(context.session.graph(), 'services', name).length === 0) context.print('waiting for service to become available...');
        context.print(`requester: making request: ${reprMessage(request.type, request.shape, request.value)}\n`);
        const value = await callService(context, name, type, request.bytes);
        const encoded = codec.encode(`${type}_Response`, value);
        const { shape } = await decoded(context, `${type}_Response`, encoded.kind === 'bytes' ? encoded.bytes : new Uint8Array());
        context.print(`response:\n${reprMessage(`${type}_Response`, shape, value)}\n`);
      };
      await call();
      const rate = given.options.get('rate');
      if (rate === undefined) return 0;
      const pause = 1000 / Number(rate);
      while (!context.signal.aborted) {
        await untilDone(context.signal, (done) => [context.session.node().timer(pause, done)]);
        if (!context.signal.aborted) await call();
      }
      return 0;
    },
  },
];
