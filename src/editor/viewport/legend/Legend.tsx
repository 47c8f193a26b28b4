import { ActionIcon, Text, Tooltip, UnstyledButton } from '@mantine/core';
import { IconCrosshair, IconX } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { msg } from '../../../messages/message.ts';
import type { FalseColorQuantity, FalseColorScale } from '../../../spectrum/falseColor/falseColor.ts';
import { useInputDevice } from '../../flight/inputDevice.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useLegend } from '../../state/context.tsx';
import { setLegendVisible, toggleCrosshair } from './legendState.ts';
import './legend.css';
import { type LegendTexts, legendTexts, pickedPosition, pickedTexts } from './legendTexts.ts';

/** Legend of false colours, with the value at the pointer. */
export default function Legend({ colors }: { readonly colors: FalseColorScale }): ReactNode {
  const { t } = useTexts();
  const crosshair = useLegend((state) => state.crosshair);
  const shown = useLegend((state) => state.visible);
  if (!shown)
    return (
      <UnstyledButton className="sl-legend sl-legend-closed" onClick={() => setLegendVisible(true)}>
        <Text size="xs">{t(msg`Legend`)}</Text>
      </UnstyledButton>
    );
  const words = legendTexts(colors, t);
  return (
    <>
      {crosshair && <div className="sl-crosshair" aria-hidden />}
      <figure className="sl-legend" data-legend={colors.kind}>
        <figcaption className="sl-legend-title">
          <Text size="xs" fw={600} mr="auto">
            {words.title}
          </Text>
          <CrosshairButton pressed={crosshair} />
          <ActionIcon
            size="sm"
            variant="subtle"
            color="gray"
            aria-label={t(msg`Hide`)}
            onClick={() => setLegendVisible(false)}
          >
            <IconX size={14} />
          </ActionIcon>
        </figcaption>
        <Bar colors={colors} words={words} />
        <Value kind={colors.kind} spoken={crosshair} />
      </figure>
    </>
  );
}

function CrosshairButton({ pressed }: { readonly pressed: boolean }): ReactNode {
  const { t } = useTexts();
  return (
    <Tooltip label={`${t(msg`Value at the crosshair`)} (P)`} openDelay={400}>
      <ActionIcon
        size="sm"
        variant={pressed ? 'light' : 'subtle'}
        color={pressed ? undefined : 'gray'}
        aria-label={t(msg`Value at the crosshair`)}
        aria-pressed={pressed}
        onClick={toggleCrosshair}
      >
        <IconCrosshair size={15} />
      </ActionIcon>
    </Tooltip>
  );
}

/** Colour bar with its labels, and a mark at the picked value. */
function Bar({ colors, words }: { readonly colors: FalseColorScale; readonly words: LegendTexts }): ReactNode {
  const reading = useLegend((state) => state.picked);
  const mark = reading && pickedPosition(colors, reading);
  return (
    <>
      <div
        className="sl-legend-bar"
        role="img"
        aria-label={words.range}
        style={{ background: `linear-gradient(to right, ${words.stops.join(', ')})` }}
      >
        {mark !== undefined && <span className="sl-legend-mark" style={{ left: `${100 * mark}%` }} />}
      </div>
      <div className="sl-legend-ticks" aria-hidden>
        {words.ticks.map(({ part, text }) => (
          <span key={part} className={endClass(part)} style={{ left: `${100 * part}%` }}>
            {text}
          </span>
        ))}
      </div>
      {words.bands.length > 0 && (
        <ul className="sl-legend-bands">
          {words.bands.map(({ name, color }) => (
            <li key={name}>
              <span className="sl-legend-swatch" style={{ background: color }} />
              {name}
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

/** Labels at the ends are aligned inwards. */
const endClass = (part: number): string | undefined => (part < 0.02 ? 'sl-first' : part > 0.98 ? 'sl-last' : undefined);

/** `spoken`: announced to screen readers; values under a moving pointer are not. */
function Value({ kind, spoken }: { readonly kind: FalseColorQuantity; readonly spoken: boolean }): ReactNode {
  const { t } = useTexts();
  const reading = useLegend((state) => state.picked);
  const device = useInputDevice();
  const words = reading && pickedTexts(kind, reading, t);
  return (
    <Text component="output" size="xs" className="sl-legend-value" aria-live={spoken ? 'polite' : 'off'} data-reading>
      {words ? (
        <>
          <b className="sl-figure">{words.value}</b>
          <span className="sl-legend-path">
            <bdi>{words.of}</bdi>
          </span>
        </>
      ) : (
        <span>{t(device === 'touch' ? msg`Touch the picture` : msg`Point at the picture, or press P`)}</span>
      )}
    </Text>
  );
}
