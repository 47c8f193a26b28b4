import { Group, SegmentedControl, Select, Slider, Stack, Switch, Tooltip } from '@mantine/core';
import { lazy, type ReactNode, Suspense, useId } from 'react';
import type { ParamValue } from '../../graph/document/document.ts';
import {
  type ChoiceParam,
  isUnphysical,
  type NumberParam,
  type ParamSpec,
  type TextParam,
  type VectorParam,
} from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { ExpressionField } from './ExpressionField.tsx';
import { DrivenParam, ParamHeader, ParamLabel, ResetButton } from './ParamLabel.tsx';
import type { ParamProps } from './paramProps.ts';
import { sliderPosition, sliderStep, sliderValue } from './sliderScale.ts';
import { VectorControl } from './VectorControl.tsx';

/** Loaded on demand: only nodes of the graph have colours, texts and lists. */
const ColorControl = lazy(() => import('./ColorControl.tsx'));
const TextControl = lazy(async () => ({ default: (await import('./TextControl.tsx')).TextControl }));
const ListControl = lazy(async () => ({ default: (await import('./TextControl.tsx')).ListControl }));

/** Control of one parameter, chosen by its description. */
export const ParamControl = (props: ParamProps): ReactNode => <Suspense>{controlOf(props)}</Suspense>;

function controlOf(props: ParamProps): ReactNode {
  const { spec, drivenBy } = props;
  if (drivenBy !== undefined) return <DrivenParam spec={spec} by={drivenBy} />;
  switch (spec.kind) {
    case 'number':
      return <NumberControl {...props} spec={spec} />;
    case 'boolean':
      return <BooleanControl {...props} />;
    case 'choice':
      return <ChoiceControl {...props} spec={spec} />;
    case 'text':
      return spec.choices ? <TextChoiceControl {...props} spec={spec} /> : <TextControl {...props} spec={spec} />;
    case 'vector':
      return (
        <VectorControl
          spec={spec}
          set={props.set}
          value={vectorOf(spec, props.value)}
          onChange={(value) => props.onChange(value)}
        />
      );
    case 'color':
      return <ColorControl {...props} spec={spec} />;
    case 'list':
      return <ListControl {...props} spec={spec} />;
  }
}

const vectorOf = (spec: VectorParam, value: ParamValue): VectorParam['default'] =>
  Array.isArray(value) ? [Number(value[0]), Number(value[1]), Number(value[2])] : spec.default;

function NumberControl({ spec, set, value, onChange, onGestureEnd }: ParamProps<NumberParam>): ReactNode {
  const { t } = useTexts();
  const id = useId();
  const number = Number(value);
  const precision = spec.scale ? 9 : decimals(spec.step);
  return (
    <Stack gap={2}>
      <Group gap={4} wrap="nowrap" justify="space-between">
        <ParamLabel spec={spec} id={id} />
        <Group gap={2} wrap="nowrap">
          <Unphysical spec={spec} value={number} nature={String(spec.physical)} />
          <ResetButton set={set} onChange={onChange} />
          <NumberField {...{ spec, number, onChange }} label={t(spec.title)} precision={precision} />
        </Group>
      </Group>
      {spec.slider !== false && (
        <Slider
          size="xs"
          min={0}
          max={1}
          step={sliderStep(spec)}
          label={null}
          value={sliderPosition(spec, number)}
          onChange={(position) => onChange(sliderValue(spec, position), `slider ${id}`)}
          onChangeEnd={onGestureEnd}
          thumbLabel={t(spec.title)}
          thumbValueText={`${number} ${spec.unit ?? ''}`.trim()}
        />
      )}
    </Stack>
  );
}

interface UnphysicalProps {
  readonly spec: ParamSpec;
  readonly value: ParamValue;
  /** The physical value, as text. */
  readonly nature: string;
}

/** Warns that a value departs from nature. */
function Unphysical({ spec, value, nature }: UnphysicalProps): ReactNode {
  const { t } = useTexts();
  if (!isUnphysical(spec, value)) return null;
  return (
    <Tooltip label={t(msg`For teaching and comparison: in nature this is ${nature}.`)} openDelay={400}>
      <span className="sl-unphysical sl-badge">{t(msg`not physical`)}</span>
    </Tooltip>
  );
}

interface NumberFieldProps extends Pick<ParamProps<NumberParam>, 'spec' | 'onChange'> {
  readonly number: number;
  readonly label: string;
  readonly precision: number;
}

function NumberField({ spec, number, onChange, label, precision }: NumberFieldProps): ReactNode {
  const take = (value: number) => {
    const bounded = Math.min(spec.max, Math.max(spec.min, value));
    const whole = spec.integer ? Math.round(bounded) : bounded;
    if (whole !== number) onChange(whole);
  };
  return (
    <ExpressionField
      label={label}
      value={number}
      unit={spec.unit}
      decimals={precision}
      width={spec.unit ? 124 : 84}
      take={take}
    />
  );
}

const decimals = (step: number): number => Math.max(0, Math.ceil(-Math.log10(step)));

function BooleanControl({ spec, set, value, onChange }: ParamProps): ReactNode {
  const { t } = useTexts();
  const id = useId();
  return (
    <Group gap={4} wrap="nowrap" justify="space-between" mih={24}>
      <ParamLabel spec={spec} id={id} />
      <Group gap={6} wrap="nowrap">
        <Unphysical spec={spec} value={value} nature={t(spec.physical === false ? msg`off` : msg`on`)} />
        <ResetButton set={set} onChange={onChange} />
        <Switch
          size="xs"
          aria-label={t(spec.title)}
          checked={value === true}
          onChange={(event) => onChange(event.currentTarget.checked)}
        />
      </Group>
    </Group>
  );
}

/** More options than this are a list instead of segments. */
const MAX_SEGMENTS = 5;
/** So are segments whose titles need more than the narrowest panel has [px]. */
const SEGMENTS_WIDTH = 270;
/** Width of a segment [px], estimated from its bold title; Chinese characters are wide. */
const segmentWidth = (title: string): number =>
  [...title].reduce((sum, character) => sum + (character > '\u2e80' ? 12 : 6.8), 12);

function ChoiceControl({ spec, set, value, onChange }: ParamProps<ChoiceParam>): ReactNode {
  const { t } = useTexts();
  const id = useId();
  const data = spec.options.map((option) => ({ value: option.value, label: t(option.title) }));
  const width = data.reduce((sum, { label }) => sum + segmentWidth(label), 0);
  if (data.length > MAX_SEGMENTS || width > SEGMENTS_WIDTH)
    return (
      <Stack gap={2}>
        <ParamHeader {...{ spec, id, set, onChange }}>
          <Unphysical
            {...{ spec, value }}
            nature={data.find((option) => option.value === spec.physical)?.label ?? ''}
          />
        </ParamHeader>
        <Select
          size="xs"
          aria-label={t(spec.title)}
          allowDeselect={false}
          searchable={data.length > 10}
          value={String(value)}
          onChange={(chosen) => chosen !== null && onChange(chosen)}
          data={data}
        />
      </Stack>
    );
  return (
    <Stack gap={2}>
      <ParamLabel spec={spec} id={id} />
      <SegmentedControl
        size="xs"
        fullWidth
        aria-labelledby={id}
        value={String(value)}
        onChange={onChange}
        data={data}
      />
    </Stack>
  );
}

function TextChoiceControl({ spec, value, choices, onChange }: ParamProps<TextParam>): ReactNode {
  const { t } = useTexts();
  const id = useId();
  if (!choices || choices.length < 2) return null;
  return (
    <Stack gap={2}>
      <ParamLabel spec={spec} id={id} />
      <Select
        size="xs"
        aria-label={t(spec.title)}
        allowDeselect={false}
        value={String(value)}
        onChange={(chosen) => onChange(chosen || undefined)}
        data={[{ value: '', label: t(msg`Automatic`) }, ...choices.map((path) => ({ value: path, label: path }))]}
      />
    </Stack>
  );
}
