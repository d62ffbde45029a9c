// Tells listeners of the graph as it is now: once a frame at most, and only when it has changed.

import type { Link } from '../bus/link.ts';
import type { GraphView } from '../contract/page_node.ts';
import type { Unsubscribe } from '../contract/session.ts';
import type { PageParticipant } from '../page/page_participant.ts';

export class GraphWatch {
  private readonly listeners = new Set<(graph: GraphView) => void>();
  private readonly link: Link;
  private readonly frame: (draw: () => void) => void;
  private readonly participant: () => PageParticipant;
  private readonly graph: () => GraphView;
  private unwatch: (() => void) | undefined;

  constructor(link: Link, frame: (draw: () => void) => void, participant: () => PageParticipant, graph: () => GraphView) {
    this.link = link;
    this.frame = frame;
    this.participant = participant;
    this.graph = graph;
  }

  add(listener: (graph: GraphView) => void): Unsubscribe {
    this.listeners.add(listener);
    this.unwatch ??= this.watch();
    return () => {
      this.listeners.delete(listener);
      if (this.listeners.size === 0) this.close();
    };
  }

  close(): void {
    this.listeners.clear();
    this.unwatch?.();
    this.unwatch = undefined;
  }

  private watch(): () => void {
    let version = this.link.graphVersion();
    let isDrawn = true;
    return this.participant().watch({
      after: () => {
        const now = this.link.graphVersion();
        if (now === version) return;
        version = now;
        if (!isDrawn) return;
        isDrawn = false;
        this.frame(() => {
          isDrawn = true;
          if (this.unwatch === undefined) return;
          const graph = this.graph();
          for (const each of [...this.listeners]) each(graph);
        });
      },
    });
  }
}
