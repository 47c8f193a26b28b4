import { Stack, Textarea, TextInput } from '@mantine/core';
import { type KeyboardEvent, type ReactNode, useId, useState } from 'react';
import type { ListParam, TextParam } from '../../graph/nodeType.ts';
import { useTexts } from '../language/languageStore.ts';
import { ParamHeader } from './ParamLabel.tsx';
import type { ParamProps } from './paramProps.ts';

export interface LinesProps extends Pick<ParamProps<TextParam | ListParam>, 'spec' | 'set' | 'onChange'> {
  readonly text: string;
  readonly long: boolean;
  readonly take: (text: string) => void;
}

/** A field for one line or several; accepts on blur or Enter (several: Ctrl Enter). */
export function Lines({ spec, set, text, long, onChange, take }: LinesProps): ReactNode {
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
      <ParamHeader {...{ spec, id, set, onChange }} />
      {long ? (
        <Textarea {...field} autosize minRows={2} maxRows={16} classNames={{ input: 'sl-long' }} />
      ) : (
        <TextInput {...field} />
      )}
    </Stack>
  );
}
