import { listed, type Message, msg } from '../../messages/message.ts';
import './energy.css';
import { ScrollArea, Select, Stack, Switch, Text, useComputedColorScheme } from '@mantine/core';
import { type ReactNode, useMemo, useState } from 'react';
import { lineStyle } from '../../diagrams/lineStyle.ts';
import { energyFaultMessage, type RunSummary, summarizeRun } from '../../dynamics/runSummary.ts';
import { formatBeta, formatNumber, formatSeconds } from '../format.ts';
import { useTexts } from '../language/languageStore.ts';
import { userTitle } from '../panels/nodeTitle.ts';
import { useEditorState, useTelemetry } from '../state/context.tsx';
import { type SimulationRun, simulationRuns, unevaluatedSimulations } from '../state/simulationRuns.ts';
import { useInstrumentView } from '../state/useInstrumentView.ts';
import { LinePlot, type PlotLine } from './LinePlot.tsx';
import { runNames } from './runNames.ts';
import { frameIndexAt, QUANTITIES, type RunQuantity, unitOf, valuesOf } from './series.ts';

const QUANTITY_TITLES: Readonly<Record<RunQuantity, Message>> = {
  change: msg`Change of energy`,
  drift: msg`Drift of energy`,
  dragLoss: msg`Energy taken by drag`,
  total: msg`Total energy`,
  kinetic: msg`Kinetic energy`,
  potential: msg`Potential energy`,
  fastest: msg`Fastest point`,
  momentum: msg`Momentum`,
  angularMomentum: msg`Angular momentum`,
};

/** A run with its name and line style. */
interface LabeledRun extends SimulationRun {
  readonly name: string;
  readonly line: PlotLine;
}

/** Run records of all simulations of the project: plots and a table of figures. */
export default function EnergyPanel(): ReactNode {
  const { t } = useTexts();
  const [quantity, setQuantity] = useState<RunQuantity>('change');
  const [logarithmic, setLogarithmic] = useState(false);
  useInstrumentView('energy', setQuantity);
  const results = useEditorState((state) => state.results);
  const runs = useMemo(() => simulationRuns(results), [results]);
  const unit = unitOf(quantity, runs);
  const named = useLabeledRuns(runs, quantity, unit);
  return (
    <ScrollArea h="100%" type="auto" scrollbarSize={8} className="sl-panel">
      <Stack gap="xs" p="md" component="section" aria-label={t(msg`Energy`)}>
        {named.length === 0 ? (
          <Text size="sm" c="dimmed" lh={1.5}>
            {t(
              msg`Nothing has been simulated yet. A Simulate node needs matter (Mass Spring, Collider, Field), and its geometry must lead to the output. If something is wrong, the node reports it.`,
            )}
          </Text>
        ) : (
          <>
            <Select
              size="xs"
              aria-label={t(msg`Quantity`)}
              allowDeselect={false}
              value={quantity}
              onChange={(chosen) => chosen && setQuantity(chosen as RunQuantity)}
              data={QUANTITIES.map((value) => ({
                value,
                label: `${t(QUANTITY_TITLES[value])} [${unitOf(value, runs)}]`,
              }))}
            />
            <EnergyPlot runs={named} quantity={quantity} unit={unit} logarithmic={logarithmic} />
            <Switch
              size="xs"
              label={t(msg`Logarithmic (absolute values)`)}
              checked={logarithmic}
              onChange={(event) => setLogarithmic(event.currentTarget.checked)}
            />
            <EnergyTable runs={named} quantity={quantity} unit={unit} />
          </>
        )}
        <UnevaluatedNote />
      </Stack>
    </ScrollArea>
  );
}

/** Lists simulate nodes that were not evaluated because the output does not need them. */
function UnevaluatedNote(): ReactNode {
  const { t } = useTexts();
  const document = useEditorState((state) => state.history.document);
  const results = useEditorState((state) => state.results);
  const busy = useEditorState((state) => state.loading !== undefined);
  const names = useMemo(
    () => unevaluatedSimulations(document, results).map((node) => userTitle(document, node) ?? node),
    [document, results],
  );
  if (busy || names.length === 0 || results.size === 0) return null;
  return (
    <Text size="xs" c="dimmed" lh={1.5}>
      {t(
        msg`Not computed, because it does not lead to the picture: ${listed(names)}. Connect its geometry to the scene, with a Transform to see it beside the others.`,
      )}
    </Text>
  );
}

function useLabeledRuns(runs: readonly SimulationRun[], quantity: RunQuantity, unit: string): readonly LabeledRun[] {
  const { t } = useTexts();
  const document = useEditorState((state) => state.history.document);
  return useMemo(() => {
    const names = runNames(runs, (node) => userTitle(document, node), t);
    return runs.map((run, i) => {
      const line = { times: run.record.times, values: valuesOf(run.record, quantity, unit) };
      return { ...run, name: names[i]!, line };
    });
  }, [runs, quantity, unit, document, t]);
}

interface RunsProps {
  readonly runs: readonly LabeledRun[];
  readonly quantity: RunQuantity;
  readonly unit: string;
}

function EnergyPlot({ runs, quantity, unit, logarithmic }: RunsProps & { readonly logarithmic: boolean }): ReactNode {
  const { t } = useTexts();
  const lines = useMemo(() => runs.map(({ line }) => line), [runs]);
  const ariaValueText = (time: number) =>
    runs.map(({ name, line }) => `${name} ${valueAt(line, time)} ${unit}`).join('; ');
  const label = t(msg`${QUANTITY_TITLES[quantity]} over time`);
  return <LinePlot lines={lines} logarithmic={logarithmic} label={label} ariaValueText={ariaValueText} />;
}

function valueAt({ times, values }: PlotLine, t: number): string {
  const frame = frameIndexAt(times, t);
  return frame < 0 || Number.isNaN(values[frame]) ? '–' : formatNumber(values[frame]!);
}

/** Values at the page's time, and figures of the whole run. */
function EnergyTable({ runs, unit }: RunsProps): ReactNode {
  const { t } = useTexts();
  return (
    <table className="sl-energy">
      <thead>
        <tr>
          <th scope="col">{t(msg`Run`)}</th>
          <th scope="col">
            <CurrentTime unit={unit} />
          </th>
          <th
            scope="col"
            title={t(
              msg`The largest change of the energy and what drag took together, relative to the largest kinetic energy: the method’s error. – where moving objects, or drag on a graphics processor, hide it`,
            )}
          >
            {t(msg`Drift`)}
          </th>
          <th scope="col">{t(msg`Fastest`)}</th>
        </tr>
      </thead>
      {runs.map((run, n) => (
        <RunRow key={run.node} run={run} n={n} />
      ))}
    </table>
  );
}

function CurrentTime({ unit }: { readonly unit: string }): ReactNode {
  const time = useTelemetry((live) => live.t);
  return (
    <>
      {formatSeconds(time)} [{unit}]
    </>
  );
}

function RunRow({ run, n }: { readonly run: LabeledRun; readonly n: number }): ReactNode {
  const { name, record, line } = run;
  const figures = useMemo(() => summarizeRun(record), [record]);
  const { drift, fastest } = figures;
  const now = useTelemetry((live) => valueAt(line, live.t));
  const { speedOfLight: c } = record;
  return (
    <tbody>
      <tr>
        <th scope="rowgroup" colSpan={4}>
          <span className="sl-energy-name">
            <Swatch n={n} />
            {name}
          </span>
        </th>
      </tr>
      <tr>
        <td colSpan={2}>{now}</td>
        <td>{drift === undefined ? '–' : formatNumber(drift, 2)}</td>
        <td>{Number.isFinite(c) ? `${formatFractionOfC(fastest / c)} c` : `${formatNumber(fastest, 2)} m/s`}</td>
      </tr>
      <RunNotes run={run} figures={figures} />
    </tbody>
  );
}

/** Speeds near c keep all their nines, so that a value below c never reads as c. */
const formatFractionOfC = (beta: number): string => (beta > 0.1 ? formatBeta(beta) : formatNumber(beta, 2));

/** Step size, how far the run came, and its problem. */
function RunNotes({ run, figures }: { readonly run: LabeledRun; readonly figures: RunSummary }): ReactNode {
  const { t } = useTexts();
  const running = useEditorState((state) => state.interim === 'running');
  const { record, interim } = run;
  const { step, stop, speedOfLight } = record;
  const { until, fault, dragLoss = 0 } = figures;
  const h = step > 0 ? t(msg`h = ${formatNumber(step * 1000, 2)} ms`) : t(msg`adaptive h`);
  const c = Number.isFinite(speedOfLight) ? `c = ${formatNumber(speedOfLight)} m/s` : t(msg`Newtonian`);
  const drag = dragLoss > 0 && t(msg`drag took ${formatNumber(dragLoss)} J`);
  const far =
    interim && t(running ? msg`computed until ${formatSeconds(until)}` : msg`stopped at ${formatSeconds(until)}`);
  return (
    <tr>
      <td colSpan={4} className="sl-energy-notes">
        {[c, h, drag, far].filter(Boolean).join(' · ')}
        {fault && <strong>{t(energyFaultMessage(fault))}</strong>}
        {stop && <strong>{t(msg`Ended at ${formatSeconds(stop.t)}: ${stop.message}`)}</strong>}
      </td>
    </tr>
  );
}

/** A sample of the line as drawn in the plot. */
function Swatch({ n }: { readonly n: number }): ReactNode {
  const { color, dash } = lineStyle(n, useComputedColorScheme('dark'));
  return (
    <svg width="20" height="8" aria-hidden="true" className="sl-energy-swatch">
      <line x1="0" x2="20" y1="4" y2="4" stroke={color} strokeWidth="2" strokeDasharray={dash.join(' ')} />
    </svg>
  );
}
