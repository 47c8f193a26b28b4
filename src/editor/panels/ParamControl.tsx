import {
  ActionIcon,
  Badge,
  Group,
  NumberInput,
  SegmentedControl,
  Select,
  Slider,
  Stack,
  Switch,
  Text,
  Textarea,
  Tooltip,
} from '@mantine/core';
import { IconRestore } from '@tabler/icons-react';
import { type ReactNode, useId } from 'react';
import type { ParamValue } from '../../graph/document.ts';
import type { ChoiceParam, NumberParam, ParamSpec, TextParam, VectorParam } from '../../graph/nodeType.ts';
import { useTexts } from '../i18n/i18n.ts';
import { positionOf, valueAt } from './scales.ts';
import { useTypedNumber } from './useTypedNumber.ts';
import { VectorControl } from './VectorControl.tsx';

export interface ParamProps<Spec extends ParamSpec = ParamSpec> {
  readonly spec: Spec;
  /** As set in the document; undefined: the default, or what the scene suggests. */
  readonly set: ParamValue | undefined;
  /** What holds now. */
  readonly value: ParamValue;
  /** For a text whose values come from the scene. */
  readonly choices?: readonly string[];
  /** `gesture`: part of one continuous action. */
  readonly onChange: (value: ParamValue | undefined, gesture?: string) => void;
  readonly onGestureEnd: () => void;
}

/** One parameter of a node, as its description says. */
export function ParamControl(props: ParamProps): ReactNode {
  const { spec } = props;
  switch (spec.kind) {
    case 'number':
      return <NumberControl {...props} spec={spec} />;
    case 'boolean':
      return <BooleanControl {...props} />;
    case 'choice':
      return <ChoiceControl {...props} spec={spec} />;
    case 'text':
      if (spec.choices) return <TextChoiceControl {...props} spec={spec} />;
      return spec.shader ? <ShaderTextControl {...props} /> : null;
    case 'vector':
      return (
        <VectorControl spec={spec} value={vectorOf(spec, props.value)} onChange={(value) => props.onChange(value)} />
      );
    case 'color':
    case 'list':
      return null;
  }
}

const vectorOf = (spec: VectorParam, value: ParamValue): VectorParam['default'] =>
  Array.isArray(value) ? [Number(value[0]), Number(value[1]), Number(value[2])] : spec.default;

function Label({ spec, id }: { readonly spec: ParamSpec; readonly id: string }): ReactNode {
  const { any } = useTexts();
  const text = (
    <Text size="sm" id={id} className="sl-param-label" truncate>
      {any(spec.title)}
    </Text>
  );
  return spec.help ? (
    <Tooltip label={any(spec.help)} position="left" multiline maw={260} openDelay={400}>
      {text}
    </Tooltip>
  ) : (
    text
  );
}

/** What is wrong with the text is told where all problems are, with its line. */
function ShaderTextControl({ spec, set, value, onChange, onGestureEnd }: ParamProps): ReactNode {
  const id = useId();
  return (
    <Stack gap={2}>
      <Group gap={4} wrap="nowrap" justify="space-between">
        <Label spec={spec} id={id} />
        <Reset set={set} onChange={onChange} />
      </Group>
      <Textarea
        size="xs"
        autosize
        maxRows={24}
        spellCheck={false}
        aria-labelledby={id}
        styles={{ input: { fontFamily: 'monospace', whiteSpace: 'pre', overflowX: 'auto' } }}
        value={String(value)}
        onChange={(event) => onChange(event.currentTarget.value, `text ${id}`)}
        onBlur={onGestureEnd}
      />
    </Stack>
  );
}

function Reset({ set, onChange }: Pick<ParamProps, 'set' | 'onChange'>): ReactNode {
  const { t } = useTexts();
  if (set === undefined) return null;
  return (
    <Tooltip label={t('panel.reset')} openDelay={400}>
      <ActionIcon
        size="xs"
        variant="subtle"
        color="gray"
        aria-label={t('panel.reset')}
        onClick={() => onChange(undefined)}
      >
        <IconRestore size={13} />
      </ActionIcon>
    </Tooltip>
  );
}

function NumberControl({ spec, set, value, onChange, onGestureEnd }: ParamProps<NumberParam>): ReactNode {
  const { any } = useTexts();
  const id = useId();
  const number = Number(value);
  const precision = spec.scale ? 9 : decimals(spec.step);
  return (
    <Stack gap={2}>
      <Group gap={4} wrap="nowrap" justify="space-between">
        <Label spec={spec} id={id} />
        <Group gap={2} wrap="nowrap">
          <Unphysical spec={spec} number={number} />
          <Reset set={set} onChange={onChange} />
          <NumberField {...{ spec, number, onChange }} label={any(spec.title)} precision={precision} />
        </Group>
      </Group>
      {spec.slider !== false && (
        <Slider
          size="xs"
          min={0}
          max={1}
          step={spec.integer ? 1 / (spec.max - spec.min) : 0.002}
          label={null}
          value={positionOf(spec, number)}
          onChange={(position) => onChange(valueAt(spec, position), `slider ${id}`)}
          onChangeEnd={onGestureEnd}
          thumbLabel={any(spec.title)}
          thumbValueText={`${number} ${spec.unit ?? ''}`.trim()}
        />
      )}
    </Stack>
  );
}

/** A value that nature does not have is for teaching, and says so. */
function Unphysical({ spec, number }: { readonly spec: NumberParam; readonly number: number }): ReactNode {
  const { t } = useTexts();
  if (spec.physical === undefined || number === spec.physical) return null;
  return (
    <Tooltip label={t('param.unphysical.help', { value: spec.physical })} openDelay={400}>
      <Badge size="xs" variant="light" color="orange" autoContrast className="sl-unphysical">
        {t('param.unphysical')}
      </Badge>
    </Tooltip>
  );
}

interface NumberFieldProps extends Pick<ParamProps<NumberParam>, 'spec' | 'onChange'> {
  readonly number: number;
  readonly label: string;
  readonly precision: number;
}

function NumberField({ spec, number, onChange, label, precision }: NumberFieldProps): ReactNode {
  const field = useTypedNumber(number, (value) => {
    const bounded = Math.min(spec.max, Math.max(spec.min, value));
    if (bounded !== number) onChange(spec.integer ? Math.round(bounded) : bounded);
  });
  return (
    <NumberInput
      size="xs"
      w={spec.unit ? 124 : 84}
      aria-label={label}
      hideControls
      decimalScale={precision}
      thousandSeparator={'\u202f'}
      suffix={spec.unit ? ` ${spec.unit}` : ''}
      {...field}
      classNames={{ input: 'sl-number' }}
    />
  );
}

const decimals = (step: number): number => Math.max(0, Math.ceil(-Math.log10(step)));

function BooleanControl({ spec, set, value, onChange }: ParamProps): ReactNode {
  const { any } = useTexts();
  const id = useId();
  return (
    <Group gap={4} wrap="nowrap" justify="space-between" mih={24}>
      <Label spec={spec} id={id} />
      <Group gap={6} wrap="nowrap">
        <Reset set={set} onChange={onChange} />
        <Switch
          size="xs"
          aria-label={any(spec.title)}
          checked={value === true}
          onChange={(event) => onChange(event.currentTarget.checked)}
        />
      </Group>
    </Group>
  );
}

function ChoiceControl({ spec, value, onChange }: ParamProps<ChoiceParam>): ReactNode {
  const { any } = useTexts();
  const id = useId();
  return (
    <Stack gap={2}>
      <Label spec={spec} id={id} />
      <SegmentedControl
        size="xs"
        fullWidth
        aria-labelledby={id}
        value={String(value)}
        onChange={onChange}
        data={spec.options.map((option) => ({ value: option.value, label: any(option.title) }))}
      />
    </Stack>
  );
}

function TextChoiceControl({ spec, value, choices, onChange }: ParamProps<TextParam>): ReactNode {
  const { any, t } = useTexts();
  const id = useId();
  if (!choices || choices.length < 2) return null;
  return (
    <Stack gap={2}>
      <Label spec={spec} id={id} />
      <Select
        size="xs"
        aria-label={any(spec.title)}
        allowDeselect={false}
        value={String(value)}
        onChange={(chosen) => onChange(chosen || undefined)}
        data={[{ value: '', label: t('param.camera.auto') }, ...choices.map((path) => ({ value: path, label: path }))]}
      />
    </Stack>
  );
}
