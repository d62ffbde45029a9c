// Hooks that follow a Session and the browser: each subscribes when used and unsubscribes with its component.

import { useEffect, useState } from 'preact/hooks';
import type { GraphView, NodeView, Session, TimeView, TopicView } from '../../contract/session.ts';

export function useNodes(session: Session): readonly NodeView[] {
  const [nodes, setNodes] = useState(() => session.nodes());
  useEffect(() => {
    setNodes(session.nodes());
    return session.onNodes(setNodes);
  }, [session]);
  return nodes;
}

export function useTopics(session: Session): readonly TopicView[] {
  const [topics, setTopics] = useState(() => session.topics());
  useEffect(() => {
    setTopics(session.topics());
    return session.onTopics(setTopics);
  }, [session]);
  return topics;
}

export function useGraph(session: Session): GraphView {
  const [graph, setGraph] = useState(() => session.graph());
  useEffect(() => {
    setGraph(session.graph());
    return session.onGraph(setGraph);
  }, [session]);
  return graph;
}

export function useTime(session: Session): TimeView {
  const [view, setView] = useState(() => session.time.view());
  useEffect(() => {
    setView(session.time.view());
    return session.time.onChange(setView);
  }, [session]);
  return view;
}

export function useMedia(query: string): boolean {
  const [matches, setMatches] = useState(() => matchMedia(query).matches);
  useEffect(() => {
    const list = matchMedia(query);
    const update = (): void => setMatches(list.matches);
    update();
    list.addEventListener('change', update);
    return () => list.removeEventListener('change', update);
  }, [query]);
  return matches;
}

/** The time now in ms, renewed once per second while `active`. */
export function useNow(active: boolean): number {
  const [now, setNow] = useState(() => Date.now());
  useEffect(() => {
    if (!active) return undefined;
    setNow(Date.now());
    const timer = setInterval(() => setNow(Date.now()), 1000);
    return () => clearInterval(timer);
  }, [active]);
  return now;
}

/** Changes when the page's colours do: for what is drawn on a canvas. */
export function useTheme(): string {
  const dark = useMedia('(prefers-color-scheme: dark)');
  const [chosen, setChosen] = useState(() => document.documentElement.dataset['theme'] ?? '');
  useEffect(() => {
    const observer = new MutationObserver(() => setChosen(document.documentElement.dataset['theme'] ?? ''));
    observer.observe(document.documentElement, { attributeFilter: ['data-theme'] });
    return () => observer.disconnect();
  }, []);
  return chosen === '' ? (dark ? 'dark' : 'light') : chosen;
}
