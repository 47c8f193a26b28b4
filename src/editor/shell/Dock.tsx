import { useComputedColorScheme } from '@mantine/core';
import { createDockview, type DockviewApi, type DockviewTheme, type ITabRenderer } from 'dockview';
import { type ReactNode, useEffect, useRef, useState } from 'react';
import { createPortal } from 'react-dom';
import { useTexts } from '../i18n/i18n.ts';
import type { MessageKey } from '../i18n/messages.ts';
import { ControlsPanel } from '../panels/ControlsPanel.tsx';
import { ScenePanel } from '../panels/scene/ScenePanel.tsx';
import { useStudioState } from '../state/context.tsx';
import { Viewport } from '../viewport/Viewport.tsx';

const PANELS = {
  picture: { title: 'panel.picture', content: <Viewport /> },
  controls: { title: 'panel.controls', content: <ControlsPanel /> },
  scene: { title: 'panel.scene', content: <ScenePanel /> },
} as const satisfies Record<string, { title: MessageKey; content: ReactNode }>;
type PanelName = keyof typeof PANELS;

const THEMES = {
  light: { name: 'slowlight', className: 'sl-dock', colorScheme: 'light' },
  dark: { name: 'slowlight', className: 'sl-dock', colorScheme: 'dark' },
} as const satisfies Record<string, DockviewTheme>;

const SIDE_WIDTH = 308;
/** Below this the side panel goes under the picture, where that is the longer way. */
const NARROW = 700;

/** The panels, which a person may move, stack and resize. React draws into the elements that dockview keeps. */
export function Dock(): ReactNode {
  const host = useRef<HTMLDivElement>(null);
  const [elements, setElements] = useState<Partial<Record<PanelName, HTMLElement>>>({});
  const api = useDockview(host, setElements);
  useTitles(api);
  const maximized = useStudioState((state) => state.maximized);
  useEffect(() => {
    if (!api) return;
    if (maximized) api.getPanel('picture')?.api.maximize();
    else api.exitMaximizedGroup();
  }, [api, maximized]);
  return (
    <div ref={host} className="sl-dock-host">
      {Object.entries(elements).map(([name, element]) =>
        createPortal(PANELS[name as PanelName].content, element, name),
      )}
    </div>
  );
}

type SetElements = React.Dispatch<React.SetStateAction<Partial<Record<PanelName, HTMLElement>>>>;

function useDockview(host: React.RefObject<HTMLDivElement | null>, setElements: SetElements): DockviewApi | undefined {
  const [api, setApi] = useState<DockviewApi>();
  const scheme = useComputedColorScheme('dark');
  useEffect(() => {
    if (!host.current) return;
    const made = createDockview(host.current, {
      createComponent: ({ name }) => {
        const element = document.createElement('div');
        element.className = 'sl-dock-panel';
        return { element, init: () => setElements((known) => ({ ...known, [name]: element })) };
      },
      createTabComponent: plainTab,
      defaultTabComponent: 'plain',
      disableFloatingGroups: true,
      theme: THEMES.dark,
    });
    const { clientWidth, clientHeight } = host.current;
    layOut(made, clientWidth < NARROW && clientWidth < clientHeight);
    setApi(made);
    return () => {
      setElements({});
      made.dispose();
    };
  }, [host, setElements]);
  useEffect(() => api?.updateOptions({ theme: THEMES[scheme] }), [api, scheme]);
  return api;
}

/** A tab without a cross: there is no way to bring a closed panel back, and no reason to close one. */
function plainTab(): ITabRenderer {
  const element = document.createElement('span');
  element.className = 'sl-tab';
  return {
    element,
    init: ({ title, api }) => {
      element.textContent = title;
      api.onDidTitleChange((change) => {
        element.textContent = change.title;
      });
    },
  };
}

function layOut(api: DockviewApi, narrow: boolean): void {
  const picture = api.addPanel({ id: 'picture', component: 'picture', renderer: 'always' });
  const direction = narrow ? 'below' : 'right';
  const size = narrow ? { initialHeight: 260 } : { initialWidth: SIDE_WIDTH };
  const controls = api.addPanel({ id: 'controls', component: 'controls', position: { direction }, ...size });
  api.addPanel({ id: 'scene', component: 'scene', position: { referencePanel: controls }, inactive: true });
  if (!narrow) controls.group.api.setConstraints({ minimumWidth: 264, maximumWidth: 480 });
  picture.group.header.hidden = true;
  picture.group.locked = 'no-drop-target';
}

/** Tabs speak the language of the page. */
function useTitles(api: DockviewApi | undefined): void {
  const { t } = useTexts();
  useEffect(() => {
    for (const [name, panel] of Object.entries(PANELS)) api?.getPanel(name)?.api.setTitle(t(panel.title));
  }, [api, t]);
}
