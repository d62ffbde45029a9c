// Programs that lab sheets name and a site does not run: those with windows, for which the page has panels, and those
// for which there is nothing to do here. Pure.

/** Panels of the page by the names of programs with windows. */
const PANELS: ReadonlyMap<string, string> = new Map([
  ['rviz2', 'scene'],
  ['rqt_graph', 'graph'],
  ['rqt_console', 'log'],
  ['rqt_plot', 'plot'],
  ['rqt_image_view', 'image'],
  ['rqt_reconfigure', 'parameters'],
  ['rqt_tf_tree', 'frames'],
  // Its only program is view_frames.
  ['tf2_tools', 'frames'],
  ['rqt_robot_monitor', 'diagnostics'],
  ['rqt_robot_steering', 'teleop'],
  ['rqt_publisher', 'publish'],
  ['rqt_service_caller', 'services'],
  ['rqt_topic', 'topics'],
  ['rqt_bag', 'bag'],
  // A window for the others: it begins with what is running.
  ['rqt', 'graph'],
  ['rqt_gui', 'graph'],
]);

export interface OpenedPanel {
  readonly program: string;
  readonly panel: string;
  /** Behind the program's name. */
  readonly rest: readonly string[];
}

/** The panel that `rqt_graph` or `ros2 run rqt_graph rqt_graph` opens. `carried`: packages that the site has. */
export function desktopPanel(words: readonly string[], carried: readonly string[]): OpenedPanel | undefined {
  const isRun = words[0] === 'ros2' && words[1] === 'run';
  if (isRun && carried.includes(words[2] ?? '')) return undefined;
  const [program = '', ...rest] = isRun ? words.slice(3) : words;
  const panel = PANELS.get(isRun ? (words[2] ?? '') : program);
  return panel === undefined ? undefined : { program, panel, rest };
}

export type NeedlessKind = 'source' | 'build' | 'install' | 'mode';

const NEEDLESS: ReadonlyMap<string, NeedlessKind> = new Map<string, NeedlessKind>([
  ['source', 'source'],
  ['.', 'source'],
  ['colcon', 'build'],
  ['chmod', 'mode'],
  ['rosdep', 'install'],
  ['sudo', 'install'],
  ['apt', 'install'],
  ['pip', 'install'],
  ['pip3', 'install'],
]);

/** Why nothing is done for that program, and nothing needs to be. */
export function needless(program: string): NeedlessKind | undefined {
  return NEEDLESS.get(program);
}
