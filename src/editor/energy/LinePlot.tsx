import 'uplot/dist/uPlot.min.css';
import { useComputedColorScheme } from '@mantine/core';
import { type KeyboardEvent, type PointerEvent, type ReactNode, useEffect, useMemo, useRef, useState } from 'react';
import uPlot from 'uplot';
import { type ColorScheme, lineStyle } from '../../diagrams/lineStyle.ts';
import { formatSeconds } from '../format.ts';
import { useServices } from '../services.tsx';
import { useTelemetry } from '../state/context.tsx';
import { onLinearAxis, onLogarithmicAxis } from './series.ts';
import { tick, ticksWidth } from './ticks.ts';

/** A line of the plot. */
export interface PlotLine {
  readonly times: Float64Array;
  readonly values: Float64Array;
}

interface PlotProps {
  readonly lines: readonly PlotLine[];
  readonly logarithmic: boolean;
  readonly label: string;
  /** Returns the value at time t as text, for screen readers. */
  readonly ariaValueText: (t: number) => string;
}

const HEIGHT = 220; // [px]
/** Step of an arrow key, as a fraction of the plotted time range. */
const SEEK_STEP = 0.01;
const LARGE_SEEK_STEP = 0.1;

/** Lines over time with a marker at the page's time, which can be dragged or moved by keys. */
export function LinePlot({ lines, logarithmic, label, ariaValueText }: PlotProps): ReactNode {
  const { observerController } = useServices();
  const host = useRef<HTMLDivElement>(null);
  const time = useTelemetry((live) => live.t);
  const plot = useUPlot(host, lines, logarithmic, time);
  const first = Math.min(...lines.map(({ times }) => times[0] ?? 0));
  const last = Math.max(...lines.map(({ times }) => times.at(-1) ?? 0));
  const seek = (t: number) => observerController.seek(Math.min(last, Math.max(first, t)));
  const onKey = (event: KeyboardEvent) => {
    const steps = SEEK_KEYS[event.key];
    if (event.key === 'Home') seek(first);
    else if (event.key === 'End') seek(last);
    else if (steps !== undefined) seek(time + steps * (last - first));
    else return;
    event.preventDefault();
  };
  const onPointer = (event: PointerEvent<HTMLDivElement>) => {
    if (!plot || event.buttons !== 1) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    seek(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, 'x'));
  };
  return (
    <div
      ref={host}
      className="sl-plot"
      role="slider"
      tabIndex={0}
      aria-label={label}
      aria-valuemin={first}
      aria-valuemax={last}
      aria-valuenow={Math.min(last, Math.max(first, time))}
      aria-valuetext={`${formatSeconds(time)}: ${ariaValueText(time)}`}
      onKeyDown={onKey}
      onPointerDown={onPointer}
      onPointerMove={onPointer}
    />
  );
}

/** Step of each key, as a fraction of the plotted time range. */
const SEEK_KEYS: Readonly<Record<string, number>> = {
  ArrowRight: SEEK_STEP,
  ArrowUp: SEEK_STEP,
  PageUp: LARGE_SEEK_STEP,
  ArrowLeft: -SEEK_STEP,
  ArrowDown: -SEEK_STEP,
  PageDown: -LARGE_SEEK_STEP,
};

/** Recreated when the set of lines changes; when only data grow, they are replaced. */
function useUPlot(
  host: React.RefObject<HTMLDivElement | null>,
  lines: readonly PlotLine[],
  logarithmic: boolean,
  time: number,
): uPlot | undefined {
  const scheme = useComputedColorScheme('dark');
  const [plot, setPlot] = useState<uPlot>();
  const data = useMemo(() => alignedData(lines, logarithmic), [lines, logarithmic]);
  const shown = useRef(data);
  shown.current = data;
  const now = useRef(time);
  now.current = time;
  const count = lines.length;
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const mark = Object.assign(document.createElement('div'), { className: 'sl-plot-now' });
    const options = optionsOf(count, logarithmic, scheme, element.clientWidth);
    const ready = [(made: uPlot) => void made.over.append(mark)];
    const draw = [(made: uPlot) => placeTimeMarker(made, now.current)];
    const made = new uPlot({ ...options, hooks: { ready, draw } }, shown.current, element);
    const resized = new ResizeObserver(() => made.setSize({ width: element.clientWidth, height: HEIGHT }));
    resized.observe(element);
    setPlot(made);
    return () => {
      resized.disconnect();
      made.destroy();
    };
  }, [host, count, logarithmic, scheme]);
  useEffect(() => plot?.setData(data), [plot, data]);
  useEffect(() => {
    if (plot) placeTimeMarker(plot, time);
  }, [plot, time]);
  return plot;
}

/** Places the marker of the page's time. */
function placeTimeMarker({ over, valToPos }: uPlot, time: number): void {
  const mark = over.querySelector<HTMLElement>('.sl-plot-now');
  if (!mark) return;
  const x = valToPos(time, 'x');
  mark.hidden = !(x >= 0 && x <= over.clientWidth);
  mark.style.transform = `translateX(${x}px)`;
}

/** All lines on shared times, with gaps where a line has no value. */
function alignedData(lines: readonly PlotLine[], logarithmic: boolean): uPlot.AlignedData {
  const columns = lines.map(
    ({ times, values }): uPlot.AlignedData => [times, (logarithmic ? onLogarithmicAxis : onLinearAxis)(values)],
  );
  const [only] = columns;
  return only && columns.length === 1 ? only : uPlot.join(columns);
}

function optionsOf(count: number, logarithmic: boolean, scheme: ColorScheme, width: number): uPlot.Options {
  const ink = scheme === 'dark' ? '#aeb5c0' : '#4a5361';
  const grid = { stroke: scheme === 'dark' ? '#2a303b' : '#e3e7ed', width: 1 };
  const axis: uPlot.Axis = { stroke: ink, grid, ticks: grid, font: '11px "Inter Variable", sans-serif' };
  const values = (_: uPlot, splits: number[]) => splits.map(tick);
  return {
    width,
    height: HEIGHT,
    legend: { show: false },
    cursor: { y: false, drag: { x: false, y: false }, points: { size: 6 } },
    scales: { x: { time: false }, y: logarithmic ? { distr: 3 } : {} },
    axes: [
      { ...axis, size: 28, values: (_, splits) => splits.map((t) => `${tick(t)} s`), space: 56 },
      { ...axis, values, size: (_, texts) => ticksWidth(texts) },
    ],
    series: [
      {},
      ...Array.from({ length: count }, (_, i): uPlot.Series => {
        const { color, dash } = lineStyle(i, scheme);
        return { stroke: color, width: 1.75, dash: [...dash], spanGaps: true, points: { show: false } };
      }),
    ],
  };
}
