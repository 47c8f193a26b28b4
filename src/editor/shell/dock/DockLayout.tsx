import 'dockview/dist/styles/dockview.css';
import { useComputedColorScheme } from '@mantine/core';
import { createDockview, type DockviewApi, type DockviewTheme, type ITabRenderer } from 'dockview';
import { lazy, type ReactNode, Suspense, useEffect, useRef, useState } from 'react';
import { createPortal } from 'react-dom';
import { type Message, msg, type Translate } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor, useEditorState } from '../../state/context.tsx';
import type { EditorState } from '../../state/editor.ts';
import { loadPreferences } from '../../state/preferences.ts';
import { SHEET_HEIGHT, SIDE_WIDTH } from './sizes.ts';

/** Loaded on demand, so that opening the page does not wait for them. */
const ControlsPanel = lazy(() => import('../../panels/ControlsPanel.tsx'));
const GraphPanel = lazy(() => import('../../graph/GraphPanel.tsx'));
const Inspector = lazy(() => import('../../graph/inspector/Inspector.tsx'));
/** Loaded when the project has simulations. */
const EnergyPanel = lazy(() => import('../../energy/EnergyPanel.tsx'));
const LessonPanel = lazy(() => import('../../lessons/LessonPanel.tsx'));
/** Loaded when their tabs are first opened. */
const ScenePanel = lazy(() => import('../../panels/scene/ScenePanel.tsx'));
const DiagramPanel = lazy(() => import('../../diagrams/DiagramPanel.tsx'));
/** Loaded where the panels are under the picture. */
const PanelSheet = lazy(() => import('./PanelSheet.tsx'));
const ClocksPanel = lazy(() => import('../../clocks/ClocksPanel.tsx'));

const PANELS = {
  /** Its content is there before the panels are. */
  picture: { title: msg`Picture`, content: undefined },
  controls: { title: msg`Controls`, content: <ControlsPanel /> },
  scene: { title: msg`Scene`, content: <ScenePanel /> },
  diagram: { title: msg`Diagram`, content: <DiagramPanel /> },
  clocks: { title: msg`Clocks`, content: <ClocksPanel /> },
  energy: { title: msg`Energy`, content: <EnergyPanel /> },
  graph: { title: msg`Graph`, content: <GraphPanel /> },
  node: { title: msg`Node`, content: <Inspector /> },
  lesson: { title: msg`Lessons`, content: <LessonPanel /> },
} as const satisfies Record<string, { title: Message; content: ReactNode }>;
type PanelName = keyof typeof PANELS;

/** The panels behind the controls. */
const BEHIND = ['scene', 'diagram', 'clocks'] as const satisfies readonly PanelName[];
/** Whether a panel is made when it is first seen. Clocks that the picture shows are the panel's. */
const isLate = (name: string): boolean =>
  (BEHIND as readonly string[]).includes(name) && !(name === 'clocks' && loadPreferences().clockLabels);

const THEMES = {
  light: { name: 'slowlight', className: 'sl-dock', colorScheme: 'light' },
  dark: { name: 'slowlight', className: 'sl-dock', colorScheme: 'dark' },
} as const satisfies Record<string, DockviewTheme>;

const [MIN_SIDE_WIDTH, MAX_SIDE_WIDTH] = [264, 480];
const LESSON_WIDTH = 350;
/** Below this width [px] the lessons are a tab beside the controls. */
const MIN_LESSON_BESIDE_WIDTH = 1080;
/** Below this width [px], in a portrait window, the side panel goes under the picture. */
const MIN_SIDE_BY_SIDE_WIDTH = 700;
/** Fraction of the viewport's height that the graph takes. */
const GRAPH_SHARE = 0.5;
const LARGE_GRAPH_SHARE = 0.86;

interface DockLayoutProps {
  /** The element that the picture is drawn into; it becomes a panel. */
  readonly picture: HTMLElement;
  readonly onLaidOut: () => void;
}

/** Panels that the user can move, stack and resize. React renders into the elements that dockview manages. */
export default function DockLayout({ picture, onLaidOut }: DockLayoutProps): ReactNode {
  const host = useRef<HTMLDivElement>(null);
  const [elements, setElements] = useState<Partial<Record<PanelName, HTMLElement>>>({});
  const api = useDockview(host, setElements);
  usePicture(api, picture, onLaidOut);
  useGraph(api, host);
  useEnergy(api);
  useLessonPanel(api, host);
  useInstrument(api);
  useTitles(api);
  const narrow = useNarrow(api, host);
  const maximized = useEditorState((state) => state.maximized);
  useEffect(() => {
    if (!api) return;
    if (maximized) api.getPanel('picture')?.api.maximize();
    else api.exitMaximizedGroup();
  }, [api, maximized]);
  return (
    <div ref={host} className="sl-dock-panels">
      {Object.entries(elements).map(([name, element]) =>
        createPortal(<Suspense>{PANELS[name as PanelName].content}</Suspense>, element, name),
      )}
      {api && narrow && (
        <Suspense>
          <PanelSheet api={api} closedHeight={SHEET_HEIGHT} />
        </Suspense>
      )}
    </div>
  );
}

type SetElements = React.Dispatch<React.SetStateAction<Partial<Record<PanelName, HTMLElement>>>>;

function useDockview(host: React.RefObject<HTMLDivElement | null>, setElements: SetElements): DockviewApi | undefined {
  const [api, setApi] = useState<DockviewApi>();
  const scheme = useComputedColorScheme('dark');
  const { t } = useTexts();
  const say = useRef(t);
  say.current = t;
  useEffect(() => {
    if (!host.current) return;
    // What is there from the start does not open.
    let isLaidOut = false;
    const made = createDockview(host.current, {
      createComponent: ({ name }) => {
        const element = document.createElement('div');
        element.className = 'sl-dock-panel';
        return {
          element,
          init: ({ api }) => {
            const show = () => setElements((known) => ({ ...known, [name]: element }));
            if (isLate(name)) api.onDidVisibilityChange(({ isVisible }) => isVisible && show());
            else show();
          },
          dispose: () => setElements(({ [name as PanelName]: _gone, ...left }) => left),
        };
      },
      createTabComponent: plainTab,
      defaultTabComponent: 'plain',
      disableFloatingGroups: true,
      getAnnouncement: ({ kind, panel }) =>
        isLaidOut ? announcement(kind, PANELS[panel.id as PanelName].title, say.current) : null,
      theme: THEMES.dark,
    });
    layOut(made, isNarrow(host.current));
    isLaidOut = true;
    setApi(made);
    return () => {
      setElements({});
      made.dispose();
    };
  }, [host, setElements]);
  useEffect(() => api?.updateOptions({ theme: THEMES[scheme] }), [api, scheme]);
  return api;
}

/** Takes the picture among the panels, when its panel is in place: dockview places it in the next frame. */
function usePicture(api: DockviewApi | undefined, picture: HTMLElement, onLaidOut: () => void): void {
  useEffect(() => {
    if (!api) return;
    const panel = api.getPanel('picture')!.view.content.element;
    let frame = requestAnimationFrame(() => {
      frame = requestAnimationFrame(() => {
        moveInto(panel, picture);
        onLaidOut();
      });
    });
    return () => cancelAnimationFrame(frame);
  }, [api, picture, onLaidOut]);
}

/**
 * Moves an element with its focus. Where browsers cannot move what is in the document (Safari), keys that are held are
 * let go.
 */
function moveInto(place: Element & { moveBefore?: (moved: Node, before: Node | null) => void }, moved: Element): void {
  const focused = moved.contains(document.activeElement) ? (document.activeElement as HTMLElement) : undefined;
  if (place.moveBefore && moved.isConnected) place.moveBefore(moved, null);
  else place.append(moved);
  if (document.activeElement !== focused) focused?.focus();
}

/** Whether the panels are under the picture, also after the device is turned; a keyboard on the screen does not count. */
function useNarrow(api: DockviewApi | undefined, host: React.RefObject<HTMLDivElement | null>): boolean {
  const [narrow, setNarrow] = useState(false);
  useEffect(() => {
    const element = host.current;
    if (!api || !element) return;
    const observer = new ResizeObserver(() => {
      if (document.activeElement?.matches('input, textarea')) return;
      const now = isNarrow(element);
      // By then dockview has not heard of the new size.
      api.layout(element.clientWidth, element.clientHeight);
      placeControls(api, now);
      setNarrow(now);
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [api, host]);
  return narrow;
}

/** For screen readers; null: nothing is said. */
function announcement(kind: string, title: Message, t: Translate): string | null {
  switch (kind) {
    case 'open':
      return t(msg`${title} opened`);
    case 'close':
      return t(msg`${title} closed`);
    case 'maximize':
      return t(msg`${title} maximized`);
    case 'restore':
      return t(msg`${title} restored`);
    default:
      return null;
  }
}

const isNarrow = ({ clientWidth, clientHeight }: HTMLElement): boolean =>
  clientWidth < MIN_SIDE_BY_SIDE_WIDTH && clientWidth < clientHeight;

/** Shows the graph under the picture and the inspector beside the other panels; on narrow screens all in one stack. */
function useGraph(api: DockviewApi | undefined, host: React.RefObject<HTMLDivElement | null>): void {
  const editor = useEditor();
  const shown = useEditorState((state) => state.graph);
  const inspecting = useEditorState((state) => state.inspecting);
  useEffect(() => {
    const controls = api?.getPanel('controls');
    if (!api || !host.current || !shown || !controls) return;
    const below = { referencePanel: 'picture', direction: 'below' } as const;
    const position = isNarrow(host.current) ? { referencePanel: 'controls' } : below;
    const graph = api.addPanel({
      id: 'graph',
      component: 'graph',
      position,
    });
    const node = api.addPanel({
      id: 'node',
      component: 'node',
      position: { referencePanel: 'controls' },
      inactive: true,
    });
    if (graph.group !== controls.group) node.api.setActive();
    graph.api.setActive();
    return () => {
      if (api.getPanel('node')) api.removePanel(node);
      if (api.getPanel('graph')) api.removePanel(graph);
    };
  }, [api, host, shown]);
  const large = useEditorState((state) => state.graphEnlarged);
  useEffect(() => {
    const graph = api?.getPanel('graph');
    if (!shown || !graph || !host.current || graph.group === api?.getPanel('controls')?.group) return;
    graph.group.api.setSize({
      height: Math.round((large ? LARGE_GRAPH_SHARE : GRAPH_SHARE) * host.current.clientHeight),
    });
  }, [api, host, shown, large]);
  useEffect(() => {
    if (!inspecting) return;
    editor.update({ graph: true });
    api?.getPanel('node')?.api.setActive();
  }, [api, inspecting, editor]);
}

/** Shows the plots if the project has simulations. */
function useEnergy(api: DockviewApi | undefined): void {
  const shown = useEditorState(simulates);
  useEffect(() => {
    if (!api?.getPanel('controls') || !shown) return;
    const position = { referencePanel: 'controls' };
    const energy = api.addPanel({ id: 'energy', component: 'energy', position, inactive: true });
    return () => {
      if (api.getPanel('energy')) api.removePanel(energy);
    };
  }, [api, shown]);
}

/** Shows the lessons beside the picture; where there is no room, in front of the controls. */
function useLessonPanel(api: DockviewApi | undefined, host: React.RefObject<HTMLDivElement | null>): void {
  const shown = useEditorState((state) => state.lesson !== undefined);
  useEffect(() => {
    if (!api || !host.current || !shown) return;
    const beside = host.current.clientWidth >= MIN_LESSON_BESIDE_WIDTH;
    const panel = api.addPanel({
      id: 'lesson',
      component: 'lesson',
      ...(beside
        ? { position: { referencePanel: 'picture', direction: 'left' }, initialWidth: LESSON_WIDTH }
        : { position: { referencePanel: 'controls' } }),
    });
    return () => {
      if (api.getPanel('lesson')) api.removePanel(panel);
    };
  }, [api, host, shown]);
}

/** Brings the panel to the front that a lesson asks for, but not over the lesson. */
function useInstrument(api: DockviewApi | undefined): void {
  const instrument = useEditorState((state) => state.instrument);
  useEffect(() => {
    const panel = instrument && api?.getPanel(instrument.panel);
    if (panel && panel.group !== api?.getPanel('lesson')?.group) panel.api.setActive();
  }, [api, instrument]);
}

const simulates = ({ history: { document } }: EditorState): boolean =>
  [document, ...Object.values(document.groups)].some(({ nodes }) =>
    Object.values(nodes).some(({ type }) => type === 'simulate'),
  );

/** A tab without close button: panels are permanent, except for the graph, which a header button toggles. */
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

/** Moves the controls, and what is with them, beside the picture or under it, where they are not. */
function placeControls(api: DockviewApi, narrow: boolean): void {
  const { group } = api.getPanel('controls')!;
  const { group: picture } = api.getPanel('picture')!;
  const isBelow = group.element.getBoundingClientRect().top >= picture.element.getBoundingClientRect().bottom - 1;
  if (isBelow === narrow) return;
  group.api.moveTo({ group: picture, position: narrow ? 'bottom' : 'right' });
  const moved = api.getPanel('controls')!.group.api;
  moved.setConstraints(
    narrow
      ? { minimumWidth: 0, maximumWidth: Number.POSITIVE_INFINITY, minimumHeight: SHEET_HEIGHT }
      : { minimumWidth: MIN_SIDE_WIDTH, maximumWidth: MAX_SIDE_WIDTH, minimumHeight: SHEET_HEIGHT },
  );
  // What was seen stays so.
  moved.setSize(narrow ? { height: Math.round(api.height / 2) } : { width: SIDE_WIDTH });
}

function layOut(api: DockviewApi, narrow: boolean): void {
  const picture = api.addPanel({ id: 'picture', component: 'picture', renderer: 'always' });
  const direction = narrow ? 'below' : 'right';
  const size = narrow
    ? { initialHeight: SHEET_HEIGHT, minimumHeight: SHEET_HEIGHT }
    : { initialWidth: SIDE_WIDTH, minimumWidth: MIN_SIDE_WIDTH, maximumWidth: MAX_SIDE_WIDTH };
  const controls = api.addPanel({ id: 'controls', component: 'controls', position: { direction }, ...size });
  for (const id of BEHIND) api.addPanel({ id, component: id, position: { referencePanel: controls }, inactive: true });
  picture.group.header.hidden = true;
  picture.group.locked = 'no-drop-target';
}

/** Keeps tab titles in the page's language. */
function useTitles(api: DockviewApi | undefined): void {
  const { t } = useTexts();
  const graph = useEditorState((state) => state.graph);
  const energy = useEditorState(simulates);
  const lesson = useEditorState((state) => state.lesson !== undefined);
  // biome-ignore lint/correctness/useExhaustiveDependencies: these add panels
  useEffect(() => {
    for (const [name, panel] of Object.entries(PANELS)) api?.getPanel(name)?.api.setTitle(t(panel.title));
  }, [api, t, graph, energy, lesson]);
}
