import { Group, NumberInput, Select, Stack, Text, Tooltip } from '@mantine/core';
import { type ReactNode, useId } from 'react';
import type { VectorParam } from '../../graph/nodeType.ts';
import { useTexts } from '../i18n/i18n.ts';
import { useTypedNumber } from './useTypedNumber.ts';

type Vector = VectorParam['default'];

const AXES: readonly (readonly [name: string, axis: Vector])[] = [
  ['+X', [1, 0, 0]],
  ['−X', [-1, 0, 0]],
  ['+Y', [0, 1, 0]],
  ['−Y', [0, -1, 0]],
  ['+Z', [0, 0, 1]],
  ['−Z', [0, 0, -1]],
];
const COMPONENTS = ['x', 'y', 'z'] as const;
const OTHER = 'other';

interface VectorControlProps {
  readonly spec: VectorParam;
  readonly value: Vector;
  readonly onChange: (value: Vector) => void;
}

/** A direction: one of the axes, or three numbers. */
export function VectorControl({ spec, value, onChange }: VectorControlProps): ReactNode {
  const { any, t } = useTexts();
  const id = useId();
  const title = any(spec.title);
  const axis = AXES.find(([, one]) => one.every((x, i) => x === value[i]))?.[0] ?? OTHER;
  const choose = (name: string | null) => {
    const chosen = AXES.find(([one]) => one === name);
    if (chosen) onChange(chosen[1]);
  };
  return (
    <Stack gap={4} role="group" aria-labelledby={id}>
      <Group gap={4} wrap="nowrap" justify="space-between">
        <Tooltip label={any(spec.help ?? '')} position="left" multiline maw={260} openDelay={400}>
          <Text size="sm" id={id} className="sl-param-label" truncate>
            {title}
          </Text>
        </Tooltip>
        <Select
          size="xs"
          w={84}
          aria-label={title}
          allowDeselect={false}
          value={axis}
          data={[...AXES.map(([name]) => name), ...(axis === OTHER ? [{ value: OTHER, label: t('axis.other') }] : [])]}
          onChange={choose}
        />
      </Group>
      <Group gap={4} wrap="nowrap" grow>
        {COMPONENTS.map((name, i) => (
          <Component
            key={name}
            label={`${title} ${name}`}
            name={name}
            value={value[i]!}
            onChange={(x) => onChange([i === 0 ? x : value[0], i === 1 ? x : value[1], i === 2 ? x : value[2]])}
          />
        ))}
      </Group>
    </Stack>
  );
}

interface ComponentProps {
  readonly label: string;
  readonly name: string;
  readonly value: number;
  readonly onChange: (value: number) => void;
}

function Component({ label, name, value, onChange }: ComponentProps): ReactNode {
  const field = useTypedNumber(value, (number) => {
    if (number !== value) onChange(number);
  });
  return (
    <NumberInput
      size="xs"
      aria-label={label}
      leftSection={<Text size="xs">{name}</Text>}
      leftSectionWidth={24}
      hideControls
      decimalScale={6}
      {...field}
      classNames={{ input: 'sl-number' }}
    />
  );
}
