// The three messages of managed nodes that the launcher sends and hears, as CDR (XCDR1, little-endian or big-endian when read).
// They are part of ROS 2's interface and do not change with the site's definitions.

export const changeStateType = 'lifecycle_msgs/srv/ChangeState';
export const transitionEventType = 'lifecycle_msgs/msg/TransitionEvent';

/** Labels, as in the states and transitions of rclcpp_lifecycle. */
export interface StateChange {
  readonly transition: string;
  readonly startState: string;
  readonly goalState: string;
}

const headerSize = 4;

/** A request of lifecycle_msgs/srv/ChangeState: a transition by its number, without its label. */
export function changeStateRequest(transition: number): Uint8Array {
  const bytes = new Uint8Array(headerSize + 9); // id, padding, length of the label, its end
  const view = new DataView(bytes.buffer);
  view.setUint8(1, 1); // little-endian
  view.setUint8(headerSize, transition);
  view.setUint32(headerSize + 4, 1, true);
  return bytes;
}

/** `success` of a response of lifecycle_msgs/srv/ChangeState. */
export function changeStateSucceeded(bytes: Uint8Array): boolean {
  return bytes[headerSize] === 1;
}

/** Reads a lifecycle_msgs/msg/TransitionEvent; undefined: the bytes are not a valid one. */
export function readTransitionEvent(bytes: Uint8Array): StateChange | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.byteLength < headerSize) return undefined;
  const isLittle = (view.getUint8(1) & 1) === 1;
  let at = headerSize + 8; // behind the time
  const labels: string[] = [];
  while (labels.length < 3) {
    at = headerSize + Math.ceil((at + 1 - headerSize) / 4) * 4; // behind a number, aligned
    if (at + 4 > bytes.byteLength) return undefined;
    const length = view.getUint32(at, isLittle);
    at += 4;
    if (length < 1 || length > bytes.byteLength - at) return undefined;
    labels.push(new TextDecoder().decode(bytes.subarray(at, at + length - 1)));
    at += length;
  }
  const [transition = '', startState = '', goalState = ''] = labels;
  return { transition, startState, goalState };
}
