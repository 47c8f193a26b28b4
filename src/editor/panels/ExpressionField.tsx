import { TextInput, Tooltip } from '@mantine/core';
import { type KeyboardEvent, type ReactNode, useState } from 'react';
import { evaluateExpression } from '../../graph/expression.ts';
import { type LocalizedText, msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditorState } from '../state/context.tsx';

interface ExpressionFieldProps {
  readonly label: string;
  readonly value: number;
  /** As displayed beside the number. */
  readonly unit?: string;
  /** Maximum number of decimals displayed. */
  readonly decimals: number;
  readonly width?: number;
  readonly leftSection?: ReactNode;
  readonly take: (value: number) => void;
}

/**
 * A number field that accepts expressions: `0.9*c`, `30deg`, `5 km/h`. Invalid input is reported and changes nothing.
 */
export function ExpressionField({
  label,
  value,
  unit,
  decimals,
  take,
  width,
  leftSection,
}: ExpressionFieldProps): ReactNode {
  const { t } = useTexts();
  const speedOfLight = useEditorState((state) => state.picture?.speedOfLight);
  const [typed, setTyped] = useState<string>();
  const [problem, setProblem] = useState<LocalizedText>();
  const forget = () => {
    setTyped(undefined);
    setProblem(undefined);
  };
  const commit = (): void => {
    const text = plain(typed ?? '', unit);
    const result = text === '' ? undefined : evaluateExpression(text, { unit, speedOfLight });
    if (result && 'problem' in result) {
      setProblem(result.problem);
      return;
    }
    forget();
    if (result) take(result.value);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === 'Enter') commit();
    if (event.key === 'Escape') forget();
  };
  const shown = `${grouped(value, decimals)}${unit ? ` ${unit}` : ''}`;
  return (
    <Tooltip
      label={
        problem === undefined
          ? t(msg`A number, or an expression with units: 0.9*c, 30deg, 5 km/h, sqrt(2)`)
          : t(problem)
      }
      opened={problem ? true : undefined}
      color={problem ? 'red' : undefined}
      openDelay={900}
      multiline
      maw={260}
    >
      <TextInput
        size="xs"
        w={width}
        aria-label={label}
        leftSection={leftSection}
        leftSectionWidth={24}
        value={typed ?? shown}
        error={problem !== undefined}
        autoComplete="off"
        spellCheck={false}
        onFocus={(event) => event.currentTarget.select()}
        onChange={(event) => {
          setTyped(event.currentTarget.value);
          setProblem(undefined);
        }}
        onBlur={() => {
          commit();
          forget();
        }}
        onKeyDown={onKeyDown}
        classNames={{ input: 'sl-number' }}
      />
    </Tooltip>
  );
}

/** Removes the thin spaces and the unit that the field displays; not all displayed units can be parsed. */
function plain(typed: string, unit: string | undefined): string {
  const text = typed.replaceAll('\u202f', '').trim();
  return unit && text.endsWith(` ${unit}`) ? text.slice(0, -unit.length).trim() : text;
}

/** 299792458 → `299 792 458`, without trailing zeros. */
function grouped(value: number, decimals: number): string {
  const [whole = '', part] = value.toFixed(Math.min(decimals, 12)).split('.');
  const fraction = part?.replace(/0+$/, '');
  const thousands = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') : whole;
  return fraction ? `${thousands}.${fraction}` : thousands === '-0' ? '0' : thousands;
}
