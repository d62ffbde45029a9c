// The bags of the page's terminal, and of the commands that a launch file starts.

import type { BagPlace } from '../../ros2cli/command.ts';
import type { Session } from '../../contract/session.ts';

/** The shelf of the panel for bags, which comes with the first command that needs it. */
export function bagsOf(session: Session): BagPlace {
  const place = async (): Promise<BagPlace> => (await import('./bag_desk.ts')).bagDesk(session).place;
  return {
    open: async (name) => (await place()).open(name),
    create: async (name) => (await place()).create(name),
  };
}
