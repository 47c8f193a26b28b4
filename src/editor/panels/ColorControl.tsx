import { ColorInput, Group } from '@mantine/core';
import { type ReactNode, useId } from 'react';
import type { ColorParam } from '../../graph/nodeType.ts';
import { decodeSrgb } from '../../spectrum/display/srgb.ts';
import { cssColor } from '../color.ts';
import { useTexts } from '../language/languageStore.ts';
import { ParamLabel, ResetButton } from './ParamLabel.tsx';
import type { ParamProps } from './paramProps.ts';

/** A colour, edited in display sRGB; the document stores linear values. */
export default function ColorControl({ spec, set, value, onChange, onGestureEnd }: ParamProps<ColorParam>): ReactNode {
  const { t } = useTexts();
  const id = useId();
  const shown = cssColor(Array.isArray(value) ? value.map(Number) : spec.default);
  const take = (text: string) => {
    const linear = linearOf(text);
    if (linear && text !== shown) onChange(linear, `color ${id}`);
  };
  return (
    <Group gap={4} wrap="nowrap" justify="space-between">
      <ParamLabel spec={spec} id={id} />
      <Group gap={2} wrap="nowrap">
        <ResetButton set={set} onChange={onChange} />
        <ColorInput
          size="xs"
          w={124}
          aria-label={t(spec.title)}
          format="hex"
          value={shown}
          onChange={take}
          onChangeEnd={onGestureEnd}
          withEyeDropper={false}
          classNames={{ input: 'sl-number' }}
        />
      </Group>
    </Group>
  );
}

/** `#rrggbb` → linear sRGB. */
function linearOf(text: string): [number, number, number] | undefined {
  const digits = /^#([0-9a-f]{6})$/i.exec(text)?.[1];
  if (!digits) return undefined;
  const part = (at: number): number =>
    Number(decodeSrgb(Number.parseInt(digits.slice(at, at + 2), 16) / 255).toFixed(5));
  return [part(0), part(2), part(4)];
}
