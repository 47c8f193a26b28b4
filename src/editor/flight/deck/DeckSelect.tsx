import { Select, type SelectProps } from '@mantine/core';
import type { ReactNode } from 'react';
import type { LocalizedText } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';

interface DeckSelectProps<V extends string> extends Pick<SelectProps, 'label' | 'aria-label' | 'description'> {
  /** The values with their titles. */
  readonly options: readonly (readonly [V, LocalizedText])[];
  readonly value: V;
  readonly onChange: (value: V) => void;
}

/** One of the deck's choices; its list is part of the deck, which closes when something outside it is clicked. */
export function DeckSelect<V extends string>({ options, onChange, ...props }: DeckSelectProps<V>): ReactNode {
  const { t } = useTexts();
  return (
    <Select
      size="xs"
      data={options.map(([value, title]) => ({ value, label: t(title) }))}
      allowDeselect={false}
      comboboxProps={{ withinPortal: false }}
      onChange={(value) => onChange(value as V)}
      {...props}
    />
  );
}
