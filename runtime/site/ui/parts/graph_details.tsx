// Details of the node, topic, action or service that is selected in the graph, and links to the panels that show more.

import type { GraphEndpointView, GraphNodeView, GraphView, Session, TopicView } from '../../contract/session.ts';
import { isHiddenName } from '../../decode/ros_names.ts';
import { isHiddenTopic } from '../model/hidden_names.ts';
import { isShownService } from '../model/callable.ts';
import { actionEnds, boxId, serviceEnds, shownNodes, topicEnds } from '../model/graph_picture.ts';
import { formatBandwidth, formatCount, formatRate } from '../model/quantities.ts';
import { misfitsOf, topicEndsOf } from '../model/topic_qos.ts';
import { viewTexts } from '../texts_views.ts';
import { IconButton } from './button.tsx';
import { Misfits } from './misfits.tsx';
import { Name } from './name.tsx';
import { StateBadge } from './node_state.tsx';
import { useNodes } from './watch.ts';

export interface GraphDetailsProps {
  readonly session: Session;
  readonly graph: GraphView;
  readonly topics: readonly TopicView[];
  readonly hidden: boolean;
  readonly selected: string;
  readonly onSelect: (id: string) => void;
  readonly onClose: () => void;
  readonly showConsole: (process: string) => void;
  readonly showTopic: (name: string) => void;
  readonly showAction: (name: string) => void;
}

export function GraphDetails(props: GraphDetailsProps) {
  const { graph, hidden, selected, onClose } = props;
  const node = shownNodes(graph, hidden).find(({ id }) => id === selected)?.node;
  const topic = [...topicEnds(graph, hidden)].find(([name]) => boxId('topic', name) === selected);
  const action = [...actionEnds(graph, hidden)].find(([name]) => boxId('action', name) === selected);
  const service = [...serviceEnds(graph, hidden)].find(([name]) => boxId('service', name) === selected);
  const name = node?.name ?? topic?.[0] ?? action?.[0] ?? service?.[0];
  if (name === undefined) return null;
  return (
    <section class="graph-details" aria-label={viewTexts.graph.details(name)}>
      <div class="graph-details-head">
        <h3>
          <Name text={name} />
        </h3>
        <IconButton icon="close" label={viewTexts.graph.closeDetails} onClick={onClose} />
      </div>
      {node === undefined ? null : <NodeDetails {...props} node={node} />}
      {topic === undefined ? null : <TopicDetails {...props} name={topic[0]} ends={topic[1]} />}
      {action === undefined ? null : (
        <CallDetails {...props} {...OF_ACTION} name={action[0]} ends={action[1]} />
      )}
      {service === undefined ? null : (
        <CallDetails {...props} {...OF_SERVICE} name={service[0]} ends={service[1]} />
      )}
    </section>
  );
}

function NodeDetails({ node, session, hidden, onSelect, showConsole }: GraphDetailsProps & { readonly node: GraphNodeView; }) {
  const process = useNodes(session).find(({ id }) => id === node.process);
  const topics = (list: readonly GraphEndpointView[]): readonly Entry[] =>
    distinct(list.filter((each) => hidden || !isHiddenTopic(each.name))).map(({ name, type }) => ({ name, note: type, id: boxId('topic', name) }));
  const services = (list: readonly GraphEndpointView[]): readonly Entry[] =>
    distinct(list.filter((each) => hidden || !isHiddenName(each.name))).map((each) => ({
      name: each.name,
      note: each.type,
      id: hidden || isShownService(each) ? boxId('service', each.name) : null,
    }));
  const actions = (list: GraphNodeView['actionServers']): readonly Entry[] => list.map(({ name, type }) => ({ name, note: type, id: boxId('action', name) }));
  return (
    <>
      <div class="work-row">
        {process === undefined
          ? (
            <span class="hint">{viewTexts.graph.elsewhere}</span>
          )
          : (
            <>
              <StateBadge node={process} />
              <button type="button" class="button" onClick={() => showConsole(process.id)}>
                {viewTexts.graph.showConsole}
              </button>
            </>
          )}
      </div>
      <Entries title={viewTexts.graph.publishes} entries={topics(node.publishers)} onSelect={onSelect} />
      <Entries title={viewTexts.graph.subscribes} entries={topics(node.subscriptions)} onSelect={onSelect} />
      <Entries title={viewTexts.graph.serves} entries={services(node.services)} onSelect={onSelect} />
      <Entries title={viewTexts.graph.calls} entries={services(node.clients)} onSelect={onSelect} />
      <Entries title={viewTexts.graph.actionServers} entries={actions(node.actionServers)} onSelect={onSelect} />
      <Entries title={viewTexts.graph.actionClients} entries={actions(node.actionClients)} onSelect={onSelect} />
    </>
  );
}

interface Ends {
  readonly from: ReadonlySet<string>;
  readonly to: ReadonlySet<string>;
}

type EndsProps = GraphDetailsProps & { readonly name: string; readonly ends: Ends; };

function TopicDetails({ name, ends, graph, topics, hidden, onSelect, showTopic }: EndsProps) {
  const view = topics.find((each) => each.name === name);
  const entries = nodeEntries(graph, hidden);
  return (
    <>
      <div class="work-row">
        <button type="button" class="button" onClick={() => showTopic(name)}>
          {viewTexts.graph.showTopic}
        </button>
      </div>
      {view === undefined ? null : (
        <p class="graph-facts">
          <Name text={view.type} />
          {`, ${formatRate(view.rateHz)}, ${formatBandwidth(view.bytesPerSecond)}, ${viewTexts.graph.messages(formatCount(view.count))}`}
        </p>
      )}
      <Misfits list={misfitsOf(topicEndsOf(graph).get(name) ?? [])} />
      <Entries title={viewTexts.graph.publishers} entries={entries(ends.from)} onSelect={onSelect} />
      <Entries title={viewTexts.graph.subscribers} entries={entries(ends.to)} onSelect={onSelect} />
    </>
  );
}

const OF_ACTION = { servers: viewTexts.graph.actionServers, clients: viewTexts.graph.actionClients };
const OF_SERVICE = { servers: viewTexts.graph.serviceServers, clients: viewTexts.graph.serviceClients };

/** Details of an action or a service. */
function CallDetails({
  name,
  ends,
  servers,
  clients,
  graph,
  hidden,
  onSelect,
  showAction,
}: EndsProps & { readonly servers: string; readonly clients: string; }) {
  const entries = nodeEntries(graph, hidden);
  return (
    <>
      <div class="work-row">
        <button type="button" class="button" onClick={() => showAction(name)}>
          {viewTexts.graph.showAction}
        </button>
      </div>
      <Entries title={servers} entries={entries(ends.to)} onSelect={onSelect} />
      <Entries title={clients} entries={entries(ends.from)} onSelect={onSelect} />
    </>
  );
}

function nodeEntries(graph: GraphView, hidden: boolean): (ids: ReadonlySet<string>) => readonly Entry[] {
  const nodes = shownNodes(graph, hidden);
  return (ids) => nodes.filter(({ id }) => ids.has(id)).map(({ id, node }) => ({ id, name: node.name, note: '' }));
}

interface Entry {
  readonly name: string;
  readonly note: string;
  /** The id that a click selects; null: a click does nothing. */
  readonly id: string | null;
}

function Entries({ title, entries, onSelect }: { readonly title: string; readonly entries: readonly Entry[]; readonly onSelect: (id: string) => void; }) {
  if (entries.length === 0) return null;
  return (
    <div class="graph-entries">
      <h4>{title}</h4>
      <ul role="list">
        {entries.map(({ name, note, id }, index) => (
          <li key={`${name} ${index}`}>
            {id === null
              ? (
                <Name text={name} />
              )
              : (
                <button type="button" class="link-button" onClick={() => onSelect(id)}>
                  <Name text={name} />
                </button>
              )}
            {note === '' ? null : (
              <span class="graph-note">
                <Name text={note} />
              </span>
            )}
          </li>
        ))}
      </ul>
    </div>
  );
}

/** A node may have several endpoints of one name. */
function distinct(list: readonly GraphEndpointView[]): readonly GraphEndpointView[] {
  return list.filter(({ name }, index) => list.findIndex((other) => other.name === name) === index);
}
