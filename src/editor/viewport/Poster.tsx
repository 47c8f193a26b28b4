import { type ReactNode, useState } from 'react';
import { useEditorState, useTelemetry } from '../state/context.tsx';

/** Names of the examples that have a thumbnail; set by the build (vite.config.ts). */
declare const THUMBNAILS: readonly string[];

/** The thumbnail of an example, until the first picture is drawn. */
export function Poster(): ReactNode {
  const source = useEditorState(({ history, loading }) => history.origin || loading?.source || '');
  const drawn = useTelemetry((live) => live.drawn);
  const [isOver, setOver] = useState(false);
  if (drawn && !isOver) setOver(true);
  const [, name] = /^examples\/([\w-]+)\.(?:slowlight\.json|usd\w)$/.exec(source) ?? [];
  if (isOver || name === undefined || !THUMBNAILS.includes(name)) return null;
  return <img className="sl-poster" src={`examples/thumbnails/${name}.webp`} alt="" />;
}
