// Shows a fake session's page the graph as it really is, for scenes in which nodes come and go.

import { graphView } from '../../../runtime/site/bus/graph_view.ts';
import type { FakeSession } from '../../unit/ui/fake_session.ts';

export function followGraph(fake: FakeSession): void {
  const { link } = fake.broker;
  let seen = -1;
  setInterval(() => {
    const version = link.graphVersion();
    if (version === seen) return;
    seen = version;
    fake.setGraph(graphView(link.graphReplica.nodes.values(), link.records(), () => undefined));
  }, 20);
}
