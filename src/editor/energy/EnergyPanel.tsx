import './energy.css';
import { ScrollArea, Select, Stack, Switch, Text, useComputedColorScheme } from '@mantine/core';
import { type ReactNode, useMemo, useState } from 'react';
import { type Figures, figuresOf } from '../../dynamics/books.ts';
import { formatBeta, formatNumber, formatSeconds } from '../format.ts';
import { useTexts } from '../i18n/i18n.ts';
import { nodeTitle } from '../panels/nodeTitle.ts';
import { useStudioState, useTelemetry } from '../state/context.tsx';
import { type Run, runsIn, unseenIn } from '../state/runs.ts';
import { lineStyle } from './lines.ts';
import { namesOf } from './names.ts';
import { type Line, Plot } from './Plot.tsx';
import { frameAt, QUANTITIES, type Quantity, unitOf, valuesOf } from './series.ts';

/** A run with what it is called, and its line in the plot. */
interface Named extends Run {
  readonly name: string;
  readonly line: Line;
}

/** Books of all simulations of the project: plots over each other, and their figures in words. */
export default function EnergyPanel(): ReactNode {
  const { t } = useTexts();
  const [quantity, setQuantity] = useState<Quantity>('change');
  const [logarithmic, setLogarithmic] = useState(false);
  const results = useStudioState((state) => state.results);
  const runs = useMemo(() => runsIn(results), [results]);
  const unit = unitOf(quantity, runs);
  const named = useNamed(runs, quantity, unit);
  return (
    <ScrollArea h="100%" type="auto" scrollbarSize={8} className="sl-panel">
      <Stack gap="xs" p="md" component="section" aria-label={t('panel.energy')}>
        {named.length === 0 ? (
          <Text size="sm" c="dimmed" lh={1.5}>
            {t('energy.none')}
          </Text>
        ) : (
          <>
            <Select
              size="xs"
              aria-label={t('energy.quantity')}
              allowDeselect={false}
              value={quantity}
              onChange={(chosen) => chosen && setQuantity(chosen as Quantity)}
              data={QUANTITIES.map((value) => ({ value, label: `${t(`energy.${value}`)} [${unitOf(value, runs)}]` }))}
            />
            <Drawn runs={named} quantity={quantity} unit={unit} logarithmic={logarithmic} />
            <Switch
              size="xs"
              label={t('energy.logarithmic')}
              checked={logarithmic}
              onChange={(event) => setLogarithmic(event.currentTarget.checked)}
            />
            <Table runs={named} quantity={quantity} unit={unit} />
          </>
        )}
        <Unseen />
      </Stack>
    </ScrollArea>
  );
}

/** Simulate nodes that nothing is asked of: only what leads to the picture is computed. */
function Unseen(): ReactNode {
  const { t } = useTexts();
  const document = useStudioState((state) => state.history.document);
  const results = useStudioState((state) => state.results);
  const busy = useStudioState((state) => state.loading !== undefined);
  const names = useMemo(
    () => unseenIn(document, results).map((node) => nodeTitle(document, node) ?? node),
    [document, results],
  );
  if (busy || names.length === 0 || results.size === 0) return null;
  return (
    <Text size="xs" c="dimmed" lh={1.5}>
      {t('energy.unseen', { names: names.join(', ') })}
    </Text>
  );
}

function useNamed(runs: readonly Run[], quantity: Quantity, unit: string): readonly Named[] {
  const { any } = useTexts();
  const document = useStudioState((state) => state.history.document);
  return useMemo(() => {
    const names = namesOf(runs, (node) => nodeTitle(document, node), any);
    return runs.map((run, i) => {
      const line = { times: run.books.times, values: valuesOf(run.books, quantity, unit) };
      return { ...run, name: names[i]!, line };
    });
  }, [runs, quantity, unit, document, any]);
}

interface ShownProps {
  readonly runs: readonly Named[];
  readonly quantity: Quantity;
  readonly unit: string;
}

function Drawn({ runs, quantity, unit, logarithmic }: ShownProps & { readonly logarithmic: boolean }): ReactNode {
  const { t } = useTexts();
  const lines = useMemo(() => runs.map(({ line }) => line), [runs]);
  const spoken = (time: number) => runs.map(({ name, line }) => `${name} ${valueAt(line, time)} ${unit}`).join('; ');
  const label = t('energy.plot', { quantity: t(`energy.${quantity}`) });
  return <Plot lines={lines} logarithmic={logarithmic} label={label} spoken={spoken} />;
}

function valueAt({ times, values }: Line, t: number): string {
  const frame = frameAt(times, t);
  return frame < 0 ? '–' : formatNumber(values[frame]!);
}

/** What there is at the page's time, and what a run comes to as a whole. */
function Table({ runs, unit }: ShownProps): ReactNode {
  const { t } = useTexts();
  return (
    <table className="sl-energy">
      <thead>
        <tr>
          <th scope="col">{t('energy.run')}</th>
          <th scope="col">
            <Now unit={unit} />
          </th>
          <th scope="col" title={t('energy.drift.help')}>
            {t('energy.drift')}
          </th>
          <th scope="col">{t('energy.mostSpeed')}</th>
        </tr>
      </thead>
      {runs.map((run, n) => (
        <Row key={run.node} run={run} n={n} />
      ))}
    </table>
  );
}

function Now({ unit }: { readonly unit: string }): ReactNode {
  const time = useTelemetry((live) => live.t);
  return (
    <>
      {formatSeconds(time)} [{unit}]
    </>
  );
}

function Row({ run, n }: { readonly run: Named; readonly n: number }): ReactNode {
  const { name, books, line } = run;
  const figures = useMemo(() => figuresOf(books), [books]);
  const { drift, fastest } = figures;
  const now = useTelemetry((live) => valueAt(line, live.t));
  const { speedOfLight: c } = books;
  return (
    <tbody>
      <tr>
        <th scope="row">
          <span className="sl-energy-name">
            <Swatch n={n} />
            {name}
          </span>
        </th>
        <td>{now}</td>
        <td>{drift === undefined ? '–' : formatNumber(drift, 2)}</td>
        <td>{Number.isFinite(c) ? `${shareOfLight(fastest / c)} c` : `${formatNumber(fastest, 2)} m/s`}</td>
      </tr>
      <Remarks run={run} figures={figures} />
    </tbody>
  );
}

/** What is below c is told so. */
const shareOfLight = (beta: number): string => (beta > 0.1 ? formatBeta(beta) : formatNumber(beta, 2));

/** With which step, how far it came, and what went wrong. */
function Remarks({ run, figures }: { readonly run: Named; readonly figures: Figures }): ReactNode {
  const { t, said } = useTexts();
  const running = useStudioState((state) => state.interim === 'running');
  const { books, interim } = run;
  const { step, stop, speedOfLight } = books;
  const { until, grown } = figures;
  const h = step > 0 ? t('energy.step', { step: formatNumber(step * 1000, 2) }) : t('energy.adaptive');
  const c = Number.isFinite(speedOfLight) ? `c = ${formatNumber(speedOfLight)} m/s` : t('energy.newton');
  const far = interim && t(running ? 'energy.running' : 'energy.stopped', { time: formatSeconds(until) });
  return (
    <tr>
      <td colSpan={4}>
        {[c, h, far].filter(Boolean).join(' · ')}
        {grown !== undefined && <strong>{t('energy.grown', { time: formatSeconds(grown) })}</strong>}
        {stop && <strong>{t('energy.failed', { time: formatSeconds(stop.t), why: said(stop.message) })}</strong>}
      </td>
    </tr>
  );
}

/** As the line is drawn. */
function Swatch({ n }: { readonly n: number }): ReactNode {
  const { color, dash } = lineStyle(n, useComputedColorScheme('dark'));
  return (
    <svg width="20" height="8" aria-hidden="true" className="sl-energy-swatch">
      <line x1="0" x2="20" y1="4" y2="4" stroke={color} strokeWidth="2" strokeDasharray={dash.join(' ')} />
    </svg>
  );
}
