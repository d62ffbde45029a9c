// ros2 bag record, info and play. What reads and writes bags is loaded with the first of them.

import type { Bag } from '../bag/bag_file.ts';
import { bagName, withEnding } from '../bag/bag_name.ts';
import { expandName, fullTypeName } from '../decode/ros_names.ts';
import type { SiteError } from '../contract/site_error.ts';
import { bagInfo, seconds } from './bag_info.ts';
import { type Command, CommandError, type Context, type Given, has, numberOf, untilDone } from './command.ts';

const wrongArguments = 2;

function listOf(given: Given, option: string): readonly string[] | undefined {
  return given.options.get(option)?.split(' ');
}

function patternOf(given: Given, option: string): RegExp | undefined {
  const text = given.options.get(option);
  if (text === undefined || text === '') return undefined;
  try {
    return new RegExp(text);
  } catch {
    throw new CommandError(`[ERROR] [ros2bag]: '${text}' is not a regular expression`);
  }
}

/** A line as rclcpp's loggers print it. */
function logger(context: Context, name: string): (text: string, level?: string) => void {
  return (text, level = 'INFO') => {
    const now = BigInt(Math.round(context.session.time.view().now * 1e6));
    context.warn(`[${level}] [${seconds(now)}] [${name}]: ${text}`);
  };
}

const record: Command = {
  words: ['bag', 'record'],
  help: 'Record ROS data to a bag',
  positionals: [{ name: 'Topic', meaning: 'topic', optional: true, many: true }],
  options: [
    { names: ['--output', '-o'], value: 'OUTPUT', help: 'The bag to create, defaults to a timestamped name; .mcap is added' },
    { names: ['--storage', '-s'], value: 'STORAGE', choices: ['mcap'], help: "Storage identifier to be used, defaults to 'mcap'" },
    { names: ['--topics'], value: 'Topic', many: true, help: 'Space-delimited list of topics to record' },
    { names: ['--topic-types'], value: 'TopicType', many: true, help: 'Space-delimited list of topic types to record' },
    { names: ['--all', '-a'], help: 'Record all topics (Exclude hidden topic)' },
    { names: ['--all-topics'], help: 'Record all topics (Exclude hidden topic)' },
    { names: ['--regex', '-e'], value: 'REGEX', help: 'Record only topics containing provided regular expression' },
    { names: ['--exclude-regex'], value: 'REGEX', help: 'Exclude topics containing provided regular expression' },
    { names: ['--exclude-topics'], value: 'Topic', many: true, help: 'Space-delimited list of topics not being recorded' },
    { names: ['--include-hidden-topics'], help: 'Discover and record hidden topics as well' },
  ],
  run: async (context, given) => {
    const wants = wanted(given);
    const name = withEnding(given.options.get('output') ?? bagName(context.session.time.view().now));
    const { Recorder } = await import('../bag/recorder.ts');
    const output = await context.bags.create(name);
    if (output === undefined) throw new CommandError(`[ERROR] [ros2bag]: Output file '${name}' already exists.`);
    const log = logger(context, 'rosbag2_recorder');
    log('Listening for topics...');
    let finish = (): void => undefined;
    let problem: SiteError | undefined;
    const recorder = await Recorder.begin(context.session, output, {
      wants,
      onTopic: (topic) => log(`Subscribed to topic '${topic}'`),
      onEnd: (why) => {
        problem = why;
        finish();
      },
    });
    log('Recording...');
    await untilDone(context.signal, (done) => {
      finish = done;
      return [];
    });
    log('Pausing recording.');
    await recorder.stop();
    output.end();
    log('Recording stopped');
    if (problem !== undefined) throw new CommandError(`error[${problem.code}]: ${problem.message}`);
    return 0;
  },
};

/** Which topics the options name. */
function wanted(given: Given): (name: string, type: string) => boolean {
  const full = (names: readonly string[] | undefined): readonly string[] | undefined => names?.map((name) => expandName(name, ''));
  const named = full(given.positionals.length > 0 ? given.positionals : listOf(given, 'topics'));
  const types = listOf(given, 'topic-types')?.map((type) => fullTypeName(type) ?? type);
  const all = has(given, 'all') || has(given, 'all-topics');
  const pattern = patternOf(given, 'regex');
  const excludedPattern = patternOf(given, 'exclude-regex');
  const excluded = full(listOf(given, 'exclude-topics'));
  if (!all && named === undefined && types === undefined && pattern === undefined) {
    throw new CommandError('[ERROR] [ros2bag]: Need to specify at least one option out of --all, --all-topics, --topics, --topic-types or --regex');
  }
  const hidden = has(given, 'include-hidden-topics');
  return (name, type) => {
    if (excludedPattern?.test(name) === true || excluded?.includes(name) === true) return false;
    if (named?.includes(name) === true) return true;
    if (!hidden && /(?:^|\/)_/.test(name)) return false;
    return all || types?.includes(type) === true || pattern?.test(name) === true;
  };
}

async function opened(context: Context, given: Given, verb: string): Promise<Bag | undefined> {
  const [path = ''] = given.positionals;
  const [{ openBag }, source] = await Promise.all([import('../bag/bag_file.ts'), context.bags.open(path)]);
  if (source === undefined) {
    context.warn(`ros2 bag ${verb}: error: argument bag_path: Bag path '${path}' does not exist!`);
    return undefined;
  }
  const bag = await openBag(source).catch((error: SiteError) => {
    throw new CommandError([`error[${error.code}]: ${error.message}`, ...error.why.map((why) => `   = why: ${why}`)].join('\n'));
  });
  if (bag.damage !== undefined) context.warn(`[WARN] [ros2bag]: not all of it can be read: ${bag.damage}`);
  return bag;
}

const info: Command = {
  words: ['bag', 'info'],
  help: 'Print information about a bag to the screen',
  positionals: [{ name: 'bag_path', meaning: 'text' }],
  options: [{ names: ['--topic-name', '-t'], help: 'Only display topic names.' }],
  run: async (context, given) => {
    const bag = await opened(context, given, 'info');
    if (bag === undefined) return wrongArguments;
    if (has(given, 'topic-name')) { for (const { topic } of bag.channels) context.print(topic); }
    else context.print(bagInfo(bag));
    return 0;
  },
};

const play: Command = {
  words: ['bag', 'play'],
  help: 'Play back ROS data from a bag',
  positionals: [{ name: 'bag_path', meaning: 'text' }],
  options: [
    { names: ['--rate', '-r'], value: 'RATE', number: true, help: 'rate at which to play back messages. Valid range > 0.0.' },
    { names: ['--topics'], value: 'topic', many: true, help: 'Space-delimited list of topics to play.' },
    { names: ['--regex', '-e'], value: 'REGEX', help: 'Play only topics matches with regular expression.' },
    { names: ['--exclude-regex', '-x'], value: 'REGEX', help: 'regular expressions to exclude topics from replay.' },
    { names: ['--exclude-topics'], value: 'topic', many: true, help: 'Space-delimited list of topics not to play.' },
    { names: ['--loop', '-l'], help: 'enables loop playback when playing a bagfile' },
    {
      names: ['--remap', '-m'],
      value: 'REMAP',
      many: true,
      help: 'list of topics to be remapped: in the form "old_topic1:=new_topic1 old_topic2:=new_topic2 etc."',
    },
    {
      names: ['--clock'],
      value: 'CLOCK',
      number: true,
      alone: '40',
      help: 'Publish to /clock at a specific frequency in Hz. The /clock topic in the bag file is excluded then.',
    },
    { names: ['--delay', '-d'], value: 'DELAY', number: true, help: 'Sleep duration before play, in seconds.' },
    { names: ['--start-offset'], value: 'START_OFFSET', number: true, help: 'Start the playback player this many seconds into the bag file.' },
    { names: ['--playback-duration'], value: 'DURATION', number: true, help: 'Playback duration, in seconds.' },
  ],
  run: async (context, given) => {
    const bag = await opened(context, given, 'play');
    if (bag === undefined) return wrongArguments;
    const { BagPlayer, playable } = await import('../bag/player.ts');
    const { session, signal } = context;
    const log = logger(context, 'rosbag2_player');
    const [pattern, excludedPattern] = [patternOf(given, 'regex'), patternOf(given, 'exclude-regex')];
    const [named, excluded] = [listOf(given, 'topics'), listOf(given, 'exclude-topics')];
    const topics = playable(bag).filter((topic) =>
      (named === undefined && pattern === undefined) || named?.includes(topic) === true || pattern?.test(topic) === true
    )
      .filter((topic) => excluded?.includes(topic) !== true && excludedPattern?.test(topic) !== true);
    const names = new Map((listOf(given, 'remap') ?? []).map((rule) => {
      const [from = '', to = ''] = rule.split(':=');
      if (from === '' || to === '') throw new CommandError(`[ERROR] [ros2bag]: '${rule}' is not a remapping`);
      return [expandName(from, ''), expandName(to, '')] as const;
    }));
    const ns = (option: string, otherwise: number): bigint => BigInt(Math.round(Math.min(numberOf(given, option, otherwise), 1e9) * 1e9));
    const from = bag.start + ns('start-offset', 0);
    const last = has(given, 'playback-duration') ? from + ns('playback-duration', 0) : bag.end;
    const rate = numberOf(given, 'rate', 1);
    await session.learn(bag.definitions);
    log(`Set rate to ${rate}`);
    log('Playback until timestamp: -1');
    const delay = numberOf(given, 'delay', 0) * 1000;
    if (delay > 0) {
      log(`Sleep ${delay * 1e6} ns`);
      await untilDone(signal, (done) => [session.node().timer(delay, done)]);
    }
    let finish = (): void => undefined;
    const player = new BagPlayer(session, bag, () => {
      if (player.state === 'ended' || player.problem !== undefined) finish();
    }, { rate, topics, names, loop: has(given, 'loop'), clockHz: numberOf(given, 'clock', 0), from, to: last < bag.end ? last : bag.end });
    await untilDone(signal, (done) => {
      finish = done;
      if (!signal.aborted) player.play();
      return [];
    });
    const { problem } = player;
    if (problem === undefined && !signal.aborted) {
      // The last messages must arrive before the publishers are closed.
      await untilDone(signal, (done) => [session.node().timer(100, done)]);
    }
    player.close();
    if (problem !== undefined) throw new CommandError(`error[${problem.code}]: ${[problem.message, ...problem.why].join(': ')}`);
    return 0;
  },
};

export const bagCommands: readonly Command[] = [info, play, record];
