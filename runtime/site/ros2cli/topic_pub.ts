// ros2 topic pub.

import { expandName, fullTypeName } from '../decode/ros_names.ts';
import { type Command, CommandError, has, numberOf, untilDone } from './command.ts';
import { fillMessage } from './filled_message.ts';
import { reprMessage } from './python_text.ts';
import { qosAsked, qosOptions } from './subscribing.ts';

export const topicPub: Command = {
  words: ['topic', 'pub'],
  help: 'Publish a message to a topic',
  positionals: [
    { name: 'topic_name', meaning: 'topic' },
    { name: 'message_type', meaning: 'message_type' },
    { name: 'values', meaning: 'message_values', optional: true },
  ],
  options: [
    { names: ['--rate', '-r'], value: 'N', number: true, help: 'Publishing rate in Hz (default: 1)' },
    { names: ['--print', '-p'], value: 'N', number: true, help: 'Only print every N-th published message (default: 1)' },
    { names: ['--once', '-1'], help: 'Publish one message and exit' },
    { names: ['--times', '-t'], value: 'TIMES', number: true, help: 'Publish this number of times and then exit' },
    {
      names: ['--wait-matching-subscriptions', '-w'],
      value: 'N',
      help: 'Wait until finding the specified number of matching subscriptions. Defaults to 1 when using "-1"/"--once"/"--times", otherwise defaults to 0.',
    },
    { names: ['--max-wait-time-secs'], value: 'S', number: true, help: 'This sets the maximum wait time in seconds if --wait-matching-subscriptions is set' },
    { names: ['--keep-alive'], value: 'N', number: true, help: 'Keep publishing node alive for N seconds after the last msg (default: 0.1)' },
    ...qosOptions,
  ],
  run: async (context, given) => {
    const [topic = '', typed = '', yaml] = given.positionals;
    const name = expandName(topic, '');
    const type = fullTypeName(typed);
    if (type === undefined) throw new CommandError('The passed message type is invalid');
    const codec = await context.codec();
    // Said before anybody waits.
    await fillMessage(codec, type, yaml, 0);
    const times = has(given, 'once') ? 1 : numberOf(given, 'times', Infinity);
    const waited = given.options.get('wait-matching-subscriptions');
    const wanted = waited === undefined ? (times === Infinity ? 0 : 1) : Number(waited);
    const node = context.session.node();
    const publisher = node.publisher(name, type, qosAsked(given));
    if (publisher.problem !== undefined) throw new CommandError(publisher.problem.message);
    try {
      let isLate = false;
      const late = numberOf(given, 'max-wait-time-secs', Infinity);
      if (publisher.matched() < wanted) {
        await untilDone(context.signal, (done) => {
          let seconds = 0;
          context.print(`Waiting for at least ${wanted} matching subscription(s)...`);
          const look = node.timer(50, () => {
            if (publisher.matched() >= wanted) done();
          });
          const told = node.timer(1000, () => {
            seconds += 1;
            if (seconds >= late) {
              isLate = true;
              done();
            } else {
              context.print(`Waiting for at least ${wanted} matching subscription(s)...`);
            }
          });
          return [look, told];
        });
        if (isLate) throw new CommandError(`Timed out waiting for subscribers: Expected ${wanted} subcribers but only got ${publisher.matched()} subscribers`);
        if (context.signal.aborted) return 130;
      }
      context.print('publisher: beginning loop');
      const every = numberOf(given, 'print', 1);
      let count = 0;
      let failure: string | undefined;
      const send = async (): Promise<void> => {
        const { bytes, value, shape } = await fillMessage(codec, type, yaml, context.session.time.view().now);
        count += 1;
        if (every === 1 || count % every === 0) context.print(`publishing #${count}: ${reprMessage(type, shape, value)}\n`);
        const problem = publisher.publish(bytes);
        if (problem !== undefined) failure = problem.message;
      };
      await send();
      if (count < times && failure === undefined) {
        await untilDone(context.signal, (done) => {
          const timer = node.timer(1000 / numberOf(given, 'rate', 1), () => {
            if (count >= times) return;
            void send().then(() => {
              if (count >= times || failure !== undefined) done();
            });
          });
          return [timer];
        });
      }
      if (failure !== undefined) throw new CommandError(failure);
      if (times !== Infinity && !context.signal.aborted) {
        await untilDone(context.signal, (done) => [node.timer(numberOf(given, 'keep-alive', 0.1) * 1000, done)]);
      }
      return 0;
    } finally {
      publisher.close();
    }
  },
};
