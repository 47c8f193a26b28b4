import './sheet.css';
import { IconChevronDown, IconChevronUp } from '@tabler/icons-react';
import type { DockviewApi } from 'dockview';
import { type ReactNode, useEffect, useMemo, useState } from 'react';
import { createPortal } from 'react-dom';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';

interface PanelSheetProps {
  readonly api: DockviewApi;
  /** Height of the tabs [px]. */
  readonly closedHeight: number;
}

/** Part of the height that an open sheet takes at first. */
const OPEN_SHARE = 0.5;
/** A sheet that is let go lower than this above its tabs closes [px]. */
const LEAST_OPEN = 70;
/** Fingers that move less tap [px]. */
const TAP = 8;

/** The panels as a sheet under the picture: closed to its tabs, opened by a tab, a drag, its button, or whatever shows a panel. */
export default function PanelSheet({ api, closedHeight }: PanelSheetProps): ReactNode {
  const { t } = useTexts();
  const { group } = useMemo(() => api.getPanel('controls')!, [api]);
  const tabs = group.element.querySelector<HTMLElement>('.dv-tabs-and-actions-container');
  const [isOpen, setOpen] = useState(false);

  useEffect(() => {
    const content = group.element.querySelector<HTMLElement>('.dv-content-container');
    const tell = () => setOpen(group.element.clientHeight > closedHeight + 1);
    // Past dockview: a group that was just moved does not tell of its size.
    const size = new ResizeObserver(tell);
    size.observe(group.element);
    group.element.classList.add('sl-sheet');
    group.api.setConstraints({ minimumHeight: closedHeight });
    return () => {
      size.disconnect();
      group.element.classList.remove('sl-sheet');
      content?.removeAttribute('inert');
    };
  }, [group, closedHeight]);

  // What is closed is not reached by Tab.
  useEffect(() => {
    group.element.querySelector('.dv-content-container')?.toggleAttribute('inert', !isOpen);
  }, [group, isOpen]);

  useEffect(() => {
    if (!tabs) return;
    const resize = (height: number) =>
      group.api.setSize({ height: Math.min(api.height - closedHeight, Math.max(closedHeight, height)) });
    const toggle = (open: boolean) => resize(open ? Math.round(OPEN_SHARE * api.height) : closedHeight);
    const isClosed = () => group.api.height <= closedHeight + 1;
    const shown = group.api.onDidActivePanelChange(() => isClosed() && toggle(true));
    // What was shown before the sheet was there, as a lesson.
    if (group.activePanel?.id !== 'controls' && isClosed()) toggle(true);
    const end = new AbortController();
    const { signal } = end;
    let from: { readonly y: number; readonly height: number; readonly wasActive: boolean } | undefined;
    let drags = false;
    tabs.addEventListener(
      'pointerdown',
      ({ clientY, target }) => {
        const wasActive = (target as Element).closest('.dv-active-tab') !== null;
        from = { y: clientY, height: group.api.height, wasActive };
        drags = false;
      },
      { signal, capture: true },
    );
    addEventListener(
      'pointermove',
      ({ clientY }) => {
        if (!from) return;
        drags ||= Math.abs(clientY - from.y) > TAP;
        if (drags) resize(from.height + from.y - clientY);
      },
      { signal },
    );
    const letGo = () => {
      if (from && drags && group.api.height < closedHeight + LEAST_OPEN) toggle(false);
      if (drags) from = undefined;
    };
    for (const type of ['pointerup', 'pointercancel'] as const) addEventListener(type, letGo, { signal });
    tabs.addEventListener(
      'click',
      ({ target }) => {
        const tapped = from;
        from = undefined;
        const element = target as Element;
        if (element.closest('.sl-sheet-button')) toggle(isClosed());
        else if (tapped?.wasActive && element.closest('.dv-tab')) toggle(isClosed());
      },
      { signal },
    );
    return () => {
      shown.dispose();
      end.abort();
    };
  }, [api, group, tabs, closedHeight]);

  return (
    tabs &&
    createPortal(
      <button type="button" className="sl-sheet-button" aria-expanded={isOpen} aria-label={t(msg`Panels`)}>
        {isOpen ? <IconChevronDown size={20} /> : <IconChevronUp size={20} />}
      </button>,
      tabs,
    )
  );
}
