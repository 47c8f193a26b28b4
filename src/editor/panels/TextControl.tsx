import { Group, Stack, Textarea, TextInput } from '@mantine/core';
import { type KeyboardEvent, type ReactNode, useId, useState } from 'react';
import type { ListParam, TextParam } from '../../graph/nodeType.ts';
import { useTexts } from '../language/languageStore.ts';
import { ParamLabel, ResetButton } from './ParamLabel.tsx';
import type { ParamProps } from './paramProps.ts';

/** Longer texts get a multiline field [characters]. */
const LONG = 60;

/** A text field; accepts on blur or Enter (multiline: Ctrl Enter). */
export function TextControl({ spec, set, value, onChange }: ParamProps<TextParam>): ReactNode {
  const text = String(value);
  const long =
    spec.shader || spec.lines || [text, spec.default].some((words) => words.includes('\n') || words.length > LONG);
  return <Lines {...{ spec, set, onChange }} text={text} long={long} take={onChange} />;
}

/** A list of texts, one per line. */
export function ListControl({ spec, set, value, onChange }: ParamProps<ListParam>): ReactNode {
  const lines = Array.isArray(value) ? value.map(String) : spec.default;
  const take = (text: string) => onChange(text.split('\n').filter((line) => line.trim() !== ''));
  return <Lines {...{ spec, set, onChange, take }} text={lines.join('\n')} long />;
}

interface LinesProps extends Pick<ParamProps<TextParam | ListParam>, 'spec' | 'set' | 'onChange'> {
  readonly text: string;
  readonly long: boolean;
  readonly take: (text: string) => void;
}

function Lines({ spec, set, text, long, onChange, take }: LinesProps): ReactNode {
  const { t } = useTexts();
  const id = useId();
  const [typed, setTyped] = useState<string>();
  const commit = () => {
    if (typed !== undefined && typed !== text) take(typed);
    setTyped(undefined);
  };
  const field = {
    size: 'xs',
    'aria-label': t(spec.title),
    value: typed ?? text,
    spellCheck: false,
    onBlur: commit,
    onChange: (event: React.ChangeEvent<HTMLInputElement | HTMLTextAreaElement>) => setTyped(event.currentTarget.value),
    onKeyDown: (event: KeyboardEvent) => {
      if (event.key === 'Enter' && (!long || event.ctrlKey || event.metaKey)) commit();
      if (event.key === 'Escape') setTyped(undefined);
    },
  } as const;
  return (
    <Stack gap={2}>
      <Group gap={4} wrap="nowrap" justify="space-between">
        <ParamLabel spec={spec} id={id} />
        <ResetButton set={set} onChange={onChange} />
      </Group>
      {long ? (
        <Textarea {...field} autosize minRows={2} maxRows={16} classNames={{ input: 'sl-long' }} />
      ) : (
        <TextInput {...field} />
      )}
    </Stack>
  );
}
