import { Group, Select, Stack, Text } from '@mantine/core';
import { type ReactNode, useId } from 'react';
import type { ParamValue } from '../../graph/document/document.ts';
import type { VectorParam } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { ExpressionField } from './ExpressionField.tsx';
import { ParamLabel, ResetButton } from './ParamLabel.tsx';

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
  readonly set: ParamValue | undefined;
  readonly value: Vector;
  readonly onChange: (value: Vector | undefined) => void;
}

/** A position or direction: a choice of axis, or three numbers. */
export function VectorControl({ spec, set, value, onChange }: VectorControlProps): ReactNode {
  const { t } = useTexts();
  const id = useId();
  const title = t(spec.title);
  const axis = AXES.find(([, one]) => one.every((x, i) => x === value[i]))?.[0] ?? OTHER;
  const choose = (name: string | null) => {
    const chosen = AXES.find(([one]) => one === name);
    if (chosen) onChange(chosen[1]);
  };
  return (
    <Stack gap={4} role="group" aria-labelledby={id}>
      <Group gap={4} wrap="nowrap" justify="space-between">
        <ParamLabel spec={spec} id={id} />
        <Group gap={4} wrap="nowrap">
          <ResetButton set={set} onChange={onChange} />
          {/* Vectors with a unit are positions, not directions. */}
          {spec.unit === undefined && (
            <Select
              size="xs"
              w={84}
              aria-label={title}
              allowDeselect={false}
              value={axis}
              data={[
                ...AXES.map(([name]) => name),
                ...(axis === OTHER ? [{ value: OTHER, label: t(msg`Other`) }] : []),
              ]}
              onChange={choose}
            />
          )}
        </Group>
      </Group>
      <Group gap={4} wrap="nowrap" grow>
        {COMPONENTS.map((name, i) => (
          <Component
            key={name}
            label={`${title} ${name}`}
            name={name}
            unit={spec.unit}
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
  readonly unit?: string;
  readonly value: number;
  readonly onChange: (value: number) => void;
}

function Component({ label, name, unit, value, onChange }: ComponentProps): ReactNode {
  return (
    <ExpressionField
      label={label}
      leftSection={<Text size="xs">{name}</Text>}
      unit={unit}
      decimals={6}
      value={value}
      take={(number) => {
        if (number !== value) onChange(number);
      }}
    />
  );
}
