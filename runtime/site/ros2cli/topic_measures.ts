// ros2 topic hz, bw and delay: figures of a topic each second, by the site's time.

import type { MessageInfo } from '../contract/session.ts';
import { type Command, CommandError, type Context, type Given, numberOf, untilDone } from './command.ts';
import { filterOf } from './filter_expression.ts';
import { chooseTopic, fittingQos, type TopicChoice } from './subscribing.ts';

const window = { names: ['--window', '-w'], value: 'WINDOW', number: true, help: 'Window size, in number of messages' } as const;
const mostHz = 50_000;

/** Takes in a message; undefined: it counts for nothing. */
type Reading = (bytes: Uint8Array, info: MessageInfo) => number | undefined;

interface Summary {
  readonly count: number;
  readonly mean: number;
  readonly least: number;
  readonly most: number;
  readonly deviation: number;
}

function summary(values: readonly number[]): Summary {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const squares = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length;
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return { count: values.length, mean, least, most, deviation: Math.sqrt(squares) };
}

/** Whether a message counts, by the expression of `--filter`. */
async function wantedBy(context: Context, { type }: TopicChoice, filter: string | undefined): Promise<(bytes: Uint8Array) => boolean> {
  if (filter === undefined) return () => true;
  const passes = filterOf(filter);
  const codec = await context.codec();
  return (bytes) => {
    const decoded = codec.decode(type, bytes);
    return decoded.kind !== 'failed' && passes(decoded.value);
  };
}

/** Reads a topic until Ctrl-C, and tells each second of the site's time. */
async function measure(
  context: Context,
  given: Given,
  topic: TopicChoice,
  read: Reading,
  tell: (values: readonly number[], news: number) => string | undefined,
  size: number,
): Promise<number> {
  const node = context.session.node();
  const values: number[] = [];
  let news = 0;
  let problem: string | undefined;
  await untilDone(context.signal, (done) => {
    const subscription = node.subscription(topic.name, topic.type, fittingQos(context, topic.name, given), (bytes, info) => {
      if (problem !== undefined) return;
      let value: number | undefined;
      try {
        value = read(bytes, info);
      } catch (error) {
        if (!(error instanceof CommandError)) throw error;
        problem = error.message;
        done();
      }
      if (value === undefined) return;
      news += 1;
      values.push(value);
      if (values.length > size) values.shift();
    });
    if (subscription.problem !== undefined) {
      problem = subscription.problem.message;
      queueMicrotask(done);
    }
    const timer = node.timer(1000, () => {
      const text = tell(values, news);
      news = 0;
      if (text !== undefined) context.print(text);
    });
    return [subscription, timer];
  });
  if (problem !== undefined) throw new CommandError(problem);
  return 0;
}

export const topicMeasures: readonly Command[] = [
  {
    words: ['topic', 'hz'],
    help: 'Print the average receiving rate to screen',
    positionals: [{ name: 'topic_name', meaning: 'topic' }],
    options: [window, { names: ['--filter'], value: 'EXPR', help: 'Python expression over the message m: only messages for which it is true are measured' }],
    run: async (context, given) => {
      const topic = chooseTopic(context, given.positionals[0]!, undefined);
      const isWanted = await wantedBy(context, topic, given.options.get('filter'));
      let last: number | undefined;
      return await measure(context, given, topic, (bytes, { receivedAt }) => {
        if (!isWanted(bytes)) return undefined;
        const gap = last === undefined ? undefined : (receivedAt - last) / 1000;
        last = receivedAt;
        return gap;
      }, (gaps, news) => {
        if (gaps.length === 0) return undefined;
        if (news === 0) return 'no new messages';
        const { count, mean, least, most, deviation } = summary(gaps);
        const rate = mean > 0 ? Math.min(1 / mean, mostHz) : mostHz;
        return `average rate: ${rate.toFixed(3)}\n\tmin: ${least.toFixed(3)}s max: ${most.toFixed(3)}s std dev: ${deviation.toFixed(5)}s window: ${count + 1}`;
      }, numberOf(given, 'window', 10_000));
    },
  },
  {
    words: ['topic', 'bw'],
    help: 'Display bandwidth used by topic',
    positionals: [{ name: 'topic_name', meaning: 'topic' }],
    options: [window],
    run: async (context, given) => {
      const topic = chooseTopic(context, given.positionals[0]!, undefined);
      const size = numberOf(given, 'window', 100);
      const times: number[] = [];
      context.print(`Subscribed to [${topic.name}]`);
      return await measure(context, given, topic, (bytes, { receivedAt }) => {
        times.push(receivedAt);
        if (times.length > size) times.shift();
        return bytes.byteLength;
      }, (sizes) => {
        if (sizes.length < 2) return undefined;
        const seconds = (context.session.time.view().now - times[0]!) / 1000;
        const { count, mean, least, most } = summary(sizes);
        const perSecond = mean * count / Math.max(seconds, 1e-9);
        const text = (value: number): string =>
          perSecond < 1e3 ? `${value.toFixed(0)} B` : perSecond < 1e6 ? `${(value / 1e3).toFixed(2)} KB` : `${(value / 1e6).toFixed(2)} MB`;
        return `${text(perSecond)}/s from ${count} messages\n\tMessage size mean: ${text(mean)} min: ${text(least)} max: ${text(most)}`;
      }, size);
    },
  },
  {
    words: ['topic', 'delay'],
    help: 'Display delay of topic from timestamp in header',
    positionals: [{ name: 'topic_name', meaning: 'topic' }],
    options: [window],
    run: async (context, given) => {
      const topic = chooseTopic(context, given.positionals[0]!, undefined);
      const parsed = (await context.codec()).types.get(topic.type);
      if (typeof parsed === 'string') throw new CommandError(parsed);
      const [header] = parsed.shape;
      if (header?.type !== 'std_msgs/msg/Header' || header.isArray) throw new CommandError('msg does not have header');
      return await measure(context, given, topic, (bytes, { receivedAt }) => {
        if (bytes.length < 12) return undefined;
        // The stamp is the first thing in the message.
        const view = new DataView(bytes.buffer, bytes.byteOffset + 4);
        const little = bytes[1] === 1;
        return receivedAt / 1000 - (view.getInt32(0, little) + view.getUint32(4, little) / 1e9);
      }, (delays, news) => {
        if (delays.length === 0 || news === 0) return delays.length === 0 ? undefined : 'no new messages';
        const { count, mean, least, most, deviation } = summary(delays);
        return `average delay: ${mean.toFixed(3)}\n\tmin: ${least.toFixed(3)}s max: ${most.toFixed(3)}s std dev: ${deviation.toFixed(5)}s window: ${count}`;
      }, numberOf(given, 'window', 10_000));
    },
  },
];
