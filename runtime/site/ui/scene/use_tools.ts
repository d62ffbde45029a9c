// The tool in hand of a scene's panel, what it publishes, measures or looks at, and what is said of it.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { PagePublisher, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import type { SceneOptions } from '../model/scene_options.ts';
import type { Vector } from '../model/transform.ts';
import { panelTexts } from '../texts_panels.ts';
import { sceneTexts } from '../texts_scene.ts';
import type { GroundPose } from './camera_control.ts';
import type { Picked } from './pick.ts';
import { estimateValue, AIMS, outletOf, pointValue, poseValue, publishStamped } from './tools.ts';
import type { SceneTool } from './tools.ts';

export interface Tools {
  readonly tool: SceneTool | null;
  readonly aims: 'pose' | 'point' | null;
  readonly choose: (tool: SceneTool | null) => void;
  /** Words beside the panel's title; empty: the usual ones. */
  readonly said: string;
  readonly say: (words: string) => void;
  /** Places that are measured between. */
  readonly measured: readonly Vector[];
  readonly onPose: (pose: GroundPose, frame: string) => void;
  readonly onPick: (picked: Picked | null, frame: string) => void;
}

const HINTS: Readonly<Record<SceneTool, string>> = {
  goal: panelTexts.scene.goalHint,
  estimate: sceneTexts.tools.estimateHint,
  point: sceneTexts.tools.pointHint,
  inspect: sceneTexts.tools.inspectHint,
  measure: sceneTexts.tools.measureHint,
};
const NO_PLACES: readonly Vector[] = [];

export function useTools(
  session: Session,
  codec: Codec | string | null,
  options: SceneOptions,
  announce: (words: string) => void,
  inspect: (picked: Picked | null, frame: string) => void,
): Tools {
  const [tool, choose] = useState<SceneTool | null>(null);
  const [said, setSaid] = useState('');
  const [measured, setMeasured] = useState(NO_PLACES);
  const publisher = useRef<PagePublisher | null>(null);
  const outlet = outletOf(tool, options);

  useEffect(() => {
    if (tool === null) return undefined;
    setSaid(HINTS[tool]);
    return () => {
      setSaid('');
      setMeasured(NO_PLACES);
    };
  }, [tool]);
  useEffect(() => {
    if (outlet === null) return undefined;
    publisher.current = session.node().publisher(outlet.topic, outlet.type);
    return () => {
      publisher.current?.close();
      publisher.current = null;
    };
  }, [session, outlet?.topic, outlet?.type]);

  const say = (words: string): void => {
    setSaid(words);
    announce(words);
  };
  const publish = (frame: string, body: Readonly<Record<string, unknown>>, sent: string): void => {
    if (outlet !== null) say(publishStamped(session, codec, publisher.current, outlet, frame, body, sent));
  };
  const onPose = (pose: GroundPose, frame: string): void => {
    const { place: [x, y], heading } = pose;
    const words = [x.toFixed(2), y.toFixed(2), ((heading * 180) / Math.PI).toFixed(0)] as const;
    if (tool === 'estimate') publish(frame, { pose: estimateValue(pose, options.variance) }, sceneTexts.tools.estimateSent(...words));
    else publish(frame, { pose: poseValue(pose) }, panelTexts.scene.goalSent(...words));
  };
  const onPick = (picked: Picked | null, frame: string): void => {
    if (tool === 'inspect') {
      if (picked === null) say(sceneTexts.tools.nothing);
      else if (picked.part === null) say(sceneTexts.tools.ground(short(picked.place[0]), short(picked.place[1])));
      inspect(picked?.part === null ? null : picked, frame);
      return;
    }
    if (picked === null) {
      say(sceneTexts.tools.nothing);
      return;
    }
    const { place } = picked;
    if (tool === 'point') publish(frame, { point: pointValue(place) }, sceneTexts.tools.pointSent(...shorts(place)));
    else if (tool === 'measure') measure(place);
  };
  const measure = (place: Vector): void => {
    const [first] = measured;
    if (first === undefined || measured.length === 2) {
      setMeasured([place]);
      say(sceneTexts.tools.measureFrom(...shorts(place)));
      return;
    }
    setMeasured([first, place]);
    const along: Vector = [place[0] - first[0], place[1] - first[1], place[2] - first[2]];
    say(sceneTexts.tools.measured(Math.hypot(...along).toFixed(3), ...shorts(along)));
  };
  return { tool, aims: tool === null ? null : AIMS[tool], choose, said, say, measured, onPose, onPick };
}

function shorts([x, y, z]: Vector): readonly [string, string, string] {
  return [short(x), short(y), short(z)];
}

function short(value: number): string {
  // Not "-0.00".
  return (Number(value.toFixed(2)) + 0).toFixed(2);
}
