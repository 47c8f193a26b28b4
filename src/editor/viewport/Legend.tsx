import { ActionIcon, Text, Tooltip } from '@mantine/core';
import { IconCrosshair } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { BANDS, bandOf, colorRow, type FalseColor, type FalseColors, partOf } from '../../spectrum/falseColor.ts';
import { ticksOf } from '../../spectrum/falseScale.ts';
import { formatLength, formatNumber } from '../format.ts';
import { type Translate, useTexts } from '../i18n/i18n.ts';
import { useLegend } from '../state/context.tsx';
import { type Reading, toggleCrosshair } from '../state/legend.ts';

/** Colours of the bar: enough that nobody sees steps. */
const STOPS = 33;

/** What false colours mean, and the value that is pointed at. */
export function Legend(): ReactNode {
  const { t } = useTexts();
  const colors = useLegend((state) => state.colors);
  const crosshair = useLegend((state) => state.crosshair);
  if (!colors) return null;
  return (
    <>
      {crosshair && <div className="sl-crosshair" aria-hidden />}
      <figure className="sl-legend" data-legend={colors.kind}>
        <figcaption className="sl-legend-title">
          <Text size="xs" fw={600}>
            {t(`legend.${colors.kind}`)}
          </Text>
          <Tooltip label={`${t('legend.crosshair')} (P)`} openDelay={400}>
            <ActionIcon
              size="sm"
              variant={crosshair ? 'light' : 'subtle'}
              color={crosshair ? undefined : 'gray'}
              aria-label={t('legend.crosshair')}
              aria-pressed={crosshair}
              onClick={toggleCrosshair}
            >
              <IconCrosshair size={15} />
            </ActionIcon>
          </Tooltip>
        </figcaption>
        <Bar colors={colors} />
        <Value kind={colors.kind} spoken={crosshair} />
      </figure>
    </>
  );
}

/** The colours from end to end, what they mean under them, and a mark at the value that is pointed at. */
function Bar({ colors: { kind, ...scale } }: { readonly colors: FalseColors }): ReactNode {
  const { t } = useTexts();
  const value = useLegend((state) => state.reading?.value);
  const percent = (of: number) => `${100 * Math.min(1, Math.max(0, partOf(kind, of, scale)))}%`;
  const stops = colorRow(kind, scale, STOPS).map((rgb) => `rgb(${rgb.join(' ')})`);
  const range = { from: valueText(kind, scale.from), to: valueText(kind, scale.to) };
  return (
    <>
      <div
        className="sl-legend-bar"
        role="img"
        aria-label={t('legend.range', range)}
        style={{ background: `linear-gradient(to right, ${stops.join(', ')})` }}
      >
        {value !== undefined && !Number.isNaN(value) && (
          <span className="sl-legend-mark" style={{ left: percent(value) }} />
        )}
      </div>
      <div className="sl-legend-ticks" aria-hidden>
        {ticksOf(kind, scale).map((tick) => (
          <span key={tick} className={endClass(partOf(kind, tick, scale))} style={{ left: percent(tick) }}>
            {shortText(kind, tick)}
          </span>
        ))}
      </div>
      {kind === 'band' && <BandNames />}
    </>
  );
}

/** Numbers at the ends stay inside. */
const endClass = (part: number): string | undefined => (part < 0.02 ? 'sl-first' : part > 0.98 ? 'sl-last' : undefined);

function BandNames(): ReactNode {
  const { t } = useTexts();
  return (
    <ul className="sl-legend-bands">
      {BANDS.map(({ name, color }) => (
        <li key={name}>
          <span className="sl-legend-swatch" style={{ background: `rgb(${color.join(' ')})` }} />
          {t(`band.${name}`)}
        </li>
      ))}
    </ul>
  );
}

/** `spoken`: changes are told by screen readers; what the pointer passes is not. */
function Value({ kind, spoken }: { readonly kind: FalseColor; readonly spoken: boolean }): ReactNode {
  const { t } = useTexts();
  const reading = useLegend((state) => state.reading);
  return (
    <Text component="output" size="xs" className="sl-legend-value" aria-live={spoken ? 'polite' : 'off'} data-reading>
      {reading ? (
        <>
          <b className="sl-figure">{readingText(kind, reading, t)}</b>
          <span className="sl-legend-path">
            <bdi>{reading.path ?? t('legend.sky')}</bdi>
          </span>
        </>
      ) : (
        <span>{t('legend.point')}</span>
      )}
    </Text>
  );
}

function readingText(kind: FalseColor, { value }: Reading, t: Translate): string {
  if (Number.isNaN(value)) return t('legend.nothing');
  return kind === 'band' ? `${valueText(kind, value)} · ${t(`band.${bandOf(value)}`)}` : valueText(kind, value);
}

/** With its unit. */
function valueText(kind: FalseColor, value: number): string {
  if (kind === 'doppler') return `D = ${formatNumber(value)}`;
  if (kind === 'emission-time') return `${formatNumber(value)} s`;
  return kind === 'band' ? formatLength(value) : formatNumber(value);
}

/** Beside the bar there is little room. */
function shortText(kind: FalseColor, value: number): string {
  const text = formatNumber(kind === 'band' ? value * 1e6 : value, 2);
  const short = text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  return kind === 'emission-time' ? `${short} s` : short;
}
