// Words of what an opened topic shows. They come with it.

import type { EndpointQosView } from '../contract/session.ts';

/** `100 ms`; a duration of a QoS policy. */
function span(ns: number): string {
  return ns >= 1e9 ? `${ns / 1e9}\u00a0s` : `${ns / 1e6}\u00a0ms`;
}

/** `0.3 ms`, `12 ms`, `1.25 s`; before its stamp with a minus. */
function delayed(ms: number): string {
  const size = Math.abs(ms);
  return size < 1 ? `${ms.toFixed(1)}\u00a0ms` : size < 1000 ? `${ms.toFixed(0)}\u00a0ms` : `${(ms / 1000).toFixed(2)}\u00a0s`;
}

export const topicTexts = {
  /** ms after the stamps in their headers. */
  delay: ({ mean, least, most }: { readonly mean: number; readonly least: number; readonly most: number; }): string =>
    `delay ${delayed(mean)}${most - least < 0.1 ? '' : ` (${delayed(least)} to ${delayed(most)})`}`,
  ends: (topic: string): string => `Who takes part in ${topic}`,
  publishes: 'publishes',
  subscribes: 'subscribes',
  qos: (qos: EndpointQosView): string =>
    [
      qos.reliability === 'reliable' ? 'reliable' : 'best effort',
      qos.durability === 'volatile' ? 'volatile' : 'transient local',
      qos.history === 'keep_all' ? 'keep all' : `keep\u00a0last\u00a0${qos.depth}`,
      qos.deadlineNs === 0 ? 'no deadline' : `deadline\u00a0${span(qos.deadlineNs)}`,
      qos.lifespanNs === 0 ? 'no lifespan' : `lifespan\u00a0${span(qos.lifespanNs)}`,
      qos.liveliness === 'automatic' ? 'automatic liveliness' : 'liveliness manual by topic',
      qos.leaseNs === 0 ? 'no lease' : `lease\u00a0${span(qos.leaseNs)}`,
    ].join(', '),
  misfit: (subscriber: string, publisher: string, policy: string): string => `${subscriber} gets nothing from ${publisher}: ${policy}`,
  policies: {
    reliability: 'reliability (it wants reliable, best effort is offered)',
    durability: 'durability (it wants transient local, volatile is offered)',
    deadline: 'deadline (the one offered is longer than the one it wants)',
    liveliness: 'liveliness (it wants manual by topic, automatic is offered)',
    lease: 'liveliness lease duration (the one offered is longer than the one it wants)',
    type: 'their types differ',
  },
  hold: 'Hold this message',
  follow: 'Show the newest message again',
  mark: 'Mark changes',
  only: 'Only changes',
  first: 'There is no message before this one.',
  same: 'Nothing has changed.',
  since: (count: number): string => count === 1 ? 'compared with the message before' : `compared with the one ${count} messages before, which was shown`,
  was: (text: string): string => `was ${text}`,
  changed: 'changed',
  copyCommand: (topic: string): string => `Copy a command of ros2 for ${topic}`,
  pub: 'ros2 topic pub, with this message',
  echo: 'ros2 topic echo',
  field: (path: string): string => `Field ${path}`,
  copyPath: 'Copy its path',
  plot: 'Plot it',
  states: 'Show its states',
  leave: (path: string): string => `Do not choose ${path}`,
  hint: 'Choose a field to copy its path or to plot it; the arrow keys lead there.',
} as const;
