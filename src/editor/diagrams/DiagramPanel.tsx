import './diagrams.css';
import {
  Button,
  Group,
  ScrollArea,
  SegmentedControl,
  Slider,
  Stack,
  Switch,
  Text,
  useComputedColorScheme,
} from '@mantine/core';
import { type ReactNode, useMemo, useRef, useState } from 'react';
import { chosenObjects, diagramLine, thingPaths } from '../../diagrams/diagramLines.ts';
import type { DiagramKind } from '../../diagrams/sceneDiagram.ts';
import type { DiagramFrame } from '../../diagrams/spacetimeDiagram.ts';
import { suggestedPaths } from '../../diagrams/suggestedPaths.ts';
import { diagramSvg } from '../../diagrams/svg.ts';
import { msg } from '../../messages/message.ts';
import { formatBeta } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';
import { download } from '../shell/download.ts';
import { useEditor, useEditorState, useTelemetry } from '../state/context.tsx';
import { useInstrumentView } from '../state/useInstrumentView.ts';
import { DiagramView, type DrawDiagram } from './DiagramView.tsx';
import { diagramDrawer } from './diagramDrawer.ts';
import { alongAxis, betaAlong, keptAxis, MAX_BETA } from './observerMoves.ts';
import { pngFile, svgFile } from './saveDiagram.ts';

/** Things that are drawn unless they are chosen, and world lines of one picture: pieces of things may be many. */
const [SUGGESTED, MAX_LINES] = [12, 400];
/** Things that the list offers. */
const OFFERED = 300;
/** Of saved pictures [px]. */
const SAVED = { width: 1200, height: 800 } as const;

/** The spacetime diagram of the scene and its observer, and energy over speed. */
export default function DiagramPanel(): ReactNode {
  const { t } = useTexts();
  const picture = useEditorState((state) => state.picture);
  const [kind, setKind] = useState<DiagramKind>('spacetime');
  useInstrumentView('diagram', setKind);
  const [frame, setFrame] = useState<DiagramFrame>('world');
  const [plane, setPlane] = useState(false);
  const [chosen, setChosen] = useState<readonly string[]>();
  const scene = picture?.scene;
  const c = picture?.speedOfLight ?? 1;
  const things = useMemo(() => thingPaths(scene?.objects ?? []), [scene]);
  const paths = useMemo(
    () => chosen?.filter((path) => things.includes(path)) ?? (scene ? suggestedPaths(scene, SUGGESTED, c) : []),
    [chosen, things, scene, c],
  );
  const lines = useMemo(() => {
    const objects = scene ? chosenObjects(scene, paths) : [];
    return objects.slice(0, MAX_LINES).map((object) => diagramLine(object, c));
  }, [scene, paths, c]);
  const draw = useMemo(
    () => diagramDrawer({ kind, frame, plane, lines, speedOfLight: c }),
    [kind, frame, plane, lines, c],
  );
  const spacetime = kind === 'spacetime';
  return (
    <ScrollArea h="100%" type="auto" scrollbarSize={8} className="sl-panel">
      <Stack gap="xs" p="md">
        <SegmentedControl
          size="xs"
          aria-label={t(msg`Kind of diagram`)}
          value={kind}
          onChange={(value) => setKind(value as DiagramKind)}
          data={[
            { value: 'spacetime', label: t(msg`Spacetime`) },
            { value: 'energy', label: t(msg`Energy over β`) },
          ]}
        />
        {spacetime && (
          <>
            <SegmentedControl
              size="xs"
              aria-label={t(msg`Frame of the diagram`)}
              value={frame}
              onChange={(value) => setFrame(value as DiagramFrame)}
              data={[
                { value: 'world', label: t(msg`World’s frame`) },
                { value: 'observer', label: t(msg`Observer’s frame`) },
              ]}
            />
            <Switch
              size="xs"
              label={t(msg`Two dimensions of space`)}
              checked={plane}
              onChange={(event) => setPlane(event.currentTarget.checked)}
            />
          </>
        )}
        <DiagramView key={`${kind} ${plane}`} draw={draw} movable={spacetime} />
        <BetaSlider />
        <ObjectList things={things} chosen={paths} onChange={setChosen} />
        <SaveButtons draw={draw} />
      </Stack>
    </ScrollArea>
  );
}

interface ObjectListProps {
  readonly things: readonly string[];
  readonly chosen: readonly string[];
  readonly onChange: (paths: readonly string[]) => void;
}

/** Which things have their world lines drawn. */
function ObjectList({ things, chosen, onChange }: ObjectListProps): ReactNode {
  const { t } = useTexts();
  const more = things.length - OFFERED;
  return (
    <details className="sl-diagram-objects">
      <summary>{t(msg`Objects: ${chosen.length} of ${things.length}`)}</summary>
      <fieldset aria-label={t(msg`Objects of the diagram`)}>
        {things.slice(0, OFFERED).map((path) => (
          <label key={path}>
            <input
              type="checkbox"
              checked={chosen.includes(path)}
              onChange={(event) =>
                onChange(event.currentTarget.checked ? [...chosen, path] : chosen.filter((other) => other !== path))
              }
            />
            {path}
          </label>
        ))}
        {more > 0 && t(msg`${more} more`)}
      </fieldset>
    </details>
  );
}

/** The observer's velocity along the axis, whose sense stays when it changes its sign. */
function BetaSlider(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { observerController } = useServices();
  useTelemetry((live) => live.beta);
  const axis = useRef<ReturnType<typeof keptAxis>>(undefined);
  const { u } = observerController.observer;
  axis.current = keptAxis(axis.current, u);
  const direction = axis.current ?? ([0, 0, -1] as const);
  const beta = betaAlong(direction, u);
  const set = (value: number) => {
    axis.current = direction;
    // Without cruise the observer would brake at once.
    if (!editor.store.getState().cruise) editor.update({ cruise: true });
    observerController.place({ u: alongAxis(direction, value) });
  };
  return (
    <Stack gap={2}>
      <Text size="xs">{t(msg`Observer’s velocity: ${signed(beta)} c`)}</Text>
      <Slider
        size="xs"
        min={-MAX_BETA}
        max={MAX_BETA}
        step={0.01}
        label={null}
        value={Math.max(-MAX_BETA, Math.min(MAX_BETA, beta))}
        onChange={set}
        thumbLabel={t(msg`Observer’s velocity`)}
        thumbValueText={`${signed(beta)} c`}
      />
    </Stack>
  );
}

const signed = (beta: number): string => `${beta < 0 ? '−' : ''}${formatBeta(Math.abs(beta))}`;

function SaveButtons({ draw }: { readonly draw: DrawDiagram }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { observerController } = useServices();
  const scheme = useComputedColorScheme('dark');
  const save = async (format: 'svg' | 'png') => {
    const svg = diagramSvg(draw(observerController.observer, SAVED, undefined), scheme, t);
    const name = `${t(msg`Diagram`)}.${format}`;
    download(format === 'svg' ? svgFile(svg) : await pngFile(svg, SAVED), name);
    editor.notify({ kind: 'info', text: msg`Saved ${name}` });
  };
  return (
    <Group gap="xs">
      <Button size="compact-xs" variant="default" onClick={() => save('svg')}>
        {t(msg`Save SVG`)}
      </Button>
      <Button size="compact-xs" variant="default" onClick={() => save('png')}>
        {t(msg`Save PNG`)}
      </Button>
    </Group>
  );
}
