import { type CSSProperties, lazy, type ReactNode, useCallback, useState } from 'react';
import { createPortal } from 'react-dom';
import { Viewport } from '../../viewport/Viewport.tsx';
import { AfterFirstPicture } from './AfterFirstPicture.tsx';
import { SHEET_HEIGHT, SIDE_WIDTH } from './sizes.ts';

/** Loaded after the first picture. */
const DockLayout = lazy(() => import('./DockLayout.tsx'));

/** The room that the panels will have, of either layout; editor.css chooses. */
const ROOM = { '--sl-side-width': `${SIDE_WIDTH}px`, '--sl-sheet-height': `${SHEET_HEIGHT}px` } as CSSProperties;

/**
 * The picture, alone at first, then among the panels. It is drawn into one element, which moves: canvas and device
 * stay.
 */
export function Dock(): ReactNode {
  const [picture] = useState(() => {
    const element = document.createElement('div');
    element.className = 'sl-dock-panel';
    return element;
  });
  const [isLaidOut, setLaidOut] = useState(false);
  // The same function at every rendering: what is appended again loses the focus.
  const place = useCallback((alone: HTMLElement | null) => alone?.append(picture), [picture]);
  const onLaidOut = useCallback(() => setLaidOut(true), []);
  return (
    <div className="sl-dock-host">
      {createPortal(<Viewport />, picture)}
      {!isLaidOut && <div className="sl-dock-alone" style={ROOM} ref={place} />}
      <AfterFirstPicture>
        <DockLayout picture={picture} onLaidOut={onLaidOut} />
      </AfterFirstPicture>
    </div>
  );
}
