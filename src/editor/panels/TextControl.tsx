import { Button, FileButton, Group, Stack, Textarea, TextInput } from '@mantine/core';
import { type KeyboardEvent, type ReactNode, useId, useRef, useState } from 'react';
import type { ListParam, TextParam } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { isGlsl } from '../../scene/shaderText/glsl/isGlsl.ts';
import { SHADER_TEXT_LIMITS } from '../../scene/shaderText/sourceLocation.ts';
import { useTexts } from '../language/languageStore.ts';
import { download } from '../shell/download.ts';
import { ParamLabel, ResetButton } from './ParamLabel.tsx';
import type { ParamProps } from './paramProps.ts';

/** Longer texts get a multiline field [characters]. */
const LONG = 60;

/** A text field; accepts on blur or Enter (multiline: Ctrl Enter). */
export function TextControl({ spec, set, value, onChange }: ParamProps<TextParam>): ReactNode {
  const text = String(value);
  const long =
    spec.shader || spec.lines || [text, spec.default].some((words) => words.includes('\n') || words.length > LONG);
  const lines = <Lines {...{ spec, set, onChange }} text={text} long={long} take={onChange} />;
  if (!spec.shader) return lines;
  return (
    <Stack gap={4}>
      {lines}
      <ShaderFile text={text} take={onChange} />
    </Stack>
  );
}

/** Loads the text of an effect from a file, and saves it to one. */
function ShaderFile({ text, take }: Pick<LinesProps, 'text' | 'take'>): ReactNode {
  const { t } = useTexts();
  const forget = useRef<() => void>(null);
  const load = async (file: File | null) => {
    // A file that was edited meanwhile can be loaded again: browsers report only another choice.
    forget.current?.();
    // More than the limit is loaded too, so that the node says what is wrong, but never without end.
    if (file) take(await file.slice(0, 4 * SHADER_TEXT_LIMITS.length).text());
  };
  const save = () => download(new Blob([text], { type: 'text/plain' }), isGlsl(text) ? 'effect.fs' : 'effect.wgsl');
  return (
    <Group gap={4}>
      <FileButton onChange={load} resetRef={forget} accept=".wgsl,.glsl,.frag,.fs,.txt">
        {(props) => (
          <Button {...props} size="compact-xs" variant="default">
            {t(msg`Load text…`)}
          </Button>
        )}
      </FileButton>
      <Button size="compact-xs" variant="default" onClick={save}>
        {t(msg`Save text`)}
      </Button>
    </Group>
  );
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
