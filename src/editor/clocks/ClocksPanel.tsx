import './clocks.css';
import { ScrollArea, Stack, Switch, Text } from '@mantine/core';
import { lazy, type ReactNode, Suspense, useMemo, useState } from 'react';
import { chosenObjects, thingPaths } from '../../diagrams/diagramLines.ts';
import { suggestedPaths } from '../../diagrams/suggestedPaths.ts';
import { seenVelocity } from '../../flight/arc.ts';
import type { EventMark } from '../../graph/document/document.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { CLOCK_ABSENCES } from '../../scene/clocks/absences.ts';
import { type Clock, objectClocks } from '../../scene/clocks/clock.ts';
import {
  type ClockAbsence,
  type ClockObserver,
  type ClockReading,
  type ClockReadings,
  ownReadings,
  readClock,
  worldReadings,
} from '../../scene/clocks/readClock.ts';
import { formatNumber, formatSeconds } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { ObjectSelect } from '../panels/ObjectSelect.tsx';
import { useServices } from '../services.tsx';
import { useEditor, useEditorState, useTelemetry } from '../state/context.tsx';
import { loadPreferences, savePreferences } from '../state/preferences.ts';
import { SignButton } from './SignButton.tsx';
import { Stopwatch } from './Stopwatch.tsx';
import { markOwn, markSeen } from './stopwatch.ts';

/** Loaded when the labels are first shown. */
const ClockLabels = lazy(() => import('./ClockLabels.tsx'));

/** Things whose clocks are shown unless others are chosen, and clocks and marked events of one table. */
const [SUGGESTED, MAX_CLOCKS, MAX_MARKS] = [4, 40, 200];
const NO_MARKS: readonly EventMark[] = [];

/** Clocks of the ship, of the world and of chosen objects, and a stopwatch. */
export default function ClocksPanel(): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const picture = useEditorState((state) => state.picture);
  const [chosen, setChosen] = useState<readonly string[]>();
  const [labelled, setLabelled] = useState(() => loadPreferences().clockLabels);
  const marks = useEditorState((state) => state.history.document.marks) ?? NO_MARKS;
  const scene = picture?.scene;
  const c = picture?.speedOfLight ?? 1;
  const things = useMemo(() => thingPaths(scene?.objects ?? []), [scene]);
  const paths = useMemo(
    () => chosen?.filter((path) => things.includes(path)) ?? (scene ? suggestedPaths(scene, SUGGESTED, c) : []),
    [chosen, things, scene, c],
  );
  const clocks = useMemo(() => {
    const all = scene ? objectClocks(chosenObjects(scene, paths), c) : [];
    return all.filter(({ path }) => paths.includes(path));
  }, [scene, paths, c]);
  const setMarks = (changed: readonly EventMark[]) =>
    editor.edit({ kind: 'set-marks', marks: changed }, msg`change the marked events`);
  const keep = (mark: EventMark | ClockAbsence) => {
    if (typeof mark === 'string')
      editor.notify({ kind: 'info', text: msg`Nothing is marked: the clock is ${CLOCK_ABSENCES[mark]}` });
    else if (marks.length >= MAX_MARKS)
      editor.notify({ kind: 'error', text: msg`${MAX_MARKS} events are marked; remove one first` });
    else setMarks([...marks, mark]);
  };
  return (
    <ScrollArea h="100%" type="auto" scrollbarSize={8} className="sl-panel">
      <Stack gap="xs" p="md">
        <ClockTable
          clocks={clocks}
          speedOfLight={c}
          onMark={(clock, observer) => {
            const name = nextName(marks);
            keep(clock ? markSeen(name, clock, observer, c) : markOwn(name, observer));
          }}
          onRemove={(path) => setChosen(paths.filter((other) => other !== path))}
        />
        <ObjectSelect
          aria-label={t(msg`Add the clock of an object`)}
          placeholder={t(msg`Add the clock of an object…`)}
          data={things.filter((path) => !paths.includes(path))}
          disabled={paths.length >= MAX_CLOCKS}
          value={null}
          onChange={(path) => path && setChosen([...paths, path])}
        />
        <Switch
          size="xs"
          label={t(msg`Show them in the picture`)}
          checked={labelled}
          onChange={({ currentTarget: { checked: clockLabels } }) => {
            setLabelled(clockLabels);
            savePreferences({ ...loadPreferences(), clockLabels });
          }}
        />
        {labelled && (
          <Suspense>
            <ClockLabels clocks={clocks} />
          </Suspense>
        )}
        <Text size="xs" c="dimmed" lh={1.5}>
          {t(
            msg`Seen: as light shows it now, with D. Slice: at your moment, in your frame. World: at the world’s moment, by its time. ⚑ marks an event for the stopwatch.`,
          )}
        </Text>
        <Stopwatch marks={marks} speedOfLight={c} onChange={setMarks} />
      </Stack>
    </ScrollArea>
  );
}

/** The number after the greatest that is a name. */
const nextName = (marks: readonly EventMark[]): string =>
  String(1 + Math.max(0, ...marks.map(({ name }) => Number(name) || 0)));

interface TableProps {
  readonly clocks: readonly Clock[];
  /** [m/s] */
  readonly speedOfLight: number;
  /** Without a clock: of the ship. */
  readonly onMark: (clock: Clock | undefined, observer: ClockObserver) => void;
  readonly onRemove: (path: string) => void;
}

/** Follows the observer at the rate of the instruments; it is not read aloud. */
function ClockTable({ clocks, speedOfLight, onMark, onRemove }: TableProps): ReactNode {
  const { t } = useTexts();
  const { observerController } = useServices();
  const lock = useEditorState((state) => state.lock);
  useTelemetry((live) => live);
  const observed = (): ClockObserver => {
    const { observer } = observerController;
    return { ...observer, u: seenVelocity(lock, observer.u) };
  };
  const observer = observed();
  return (
    <table className="sl-clocks" aria-live="off">
      <thead>
        <tr>
          <th scope="col">{t(msg`Seen`)}</th>
          <th scope="col">{t(msg`Slice`)}</th>
          <th scope="col">{t(msg`World`)}</th>
        </tr>
      </thead>
      <ClockRows name={msg`Ship`} readings={ownReadings(observer)} onMark={() => onMark(undefined, observed())} />
      <ClockRows name={msg`World`} readings={worldReadings(observer)} />
      {clocks.map((clock) => (
        <ClockRows
          key={clock.path}
          name={clock.path}
          readings={readClock(clock, observer, speedOfLight)}
          onMark={() => onMark(clock, observed())}
          onRemove={() => onRemove(clock.path)}
        />
      ))}
    </table>
  );
}

interface RowsProps {
  readonly name: LocalizedText;
  readonly readings: ClockReadings;
  readonly onMark?: () => void;
  readonly onRemove?: () => void;
}

function ClockRows({ name, readings, onMark, onRemove }: RowsProps): ReactNode {
  const { t } = useTexts();
  return (
    <tbody>
      <tr>
        <th scope="rowgroup" colSpan={3}>
          <span className="sl-clocks-name">
            <span>{t(name)}</span>
            {onMark && <SignButton sign="⚑" title={msg`Mark: ${name}`} act={onMark} />}
            {onRemove && <SignButton sign="×" title={msg`Remove: ${name}`} act={onRemove} />}
          </span>
        </th>
      </tr>
      <tr>
        <ClockCell shown={readings.seen} sign={onRemove ? 'D' : '×'} />
        <ClockCell shown={readings.slice} sign="×" />
        <ClockCell shown={readings.world} sign="×" />
      </tr>
    </tbody>
  );
}

function ClockCell({ shown, sign }: { readonly shown: ClockReading | ClockAbsence; readonly sign: string }): ReactNode {
  const { t } = useTexts();
  if (typeof shown === 'string') return <td className="sl-clocks-absent">{t(CLOCK_ABSENCES[shown])}</td>;
  return (
    <td>
      {formatSeconds(shown.properTime)}
      <small>
        {sign} {formatNumber(shown.rate)}
      </small>
    </td>
  );
}
