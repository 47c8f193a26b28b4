import { Button, FileButton, Group, Stack } from '@mantine/core';
import { type ReactNode, useRef } from 'react';
import type { ListParam, TextParam } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { isGlsl } from '../../scene/shaderText/glsl/isGlsl.ts';
import { SHADER_TEXT_LIMITS } from '../../scene/shaderText/sourceLocation.ts';
import { useTexts } from '../language/languageStore.ts';
import { download } from '../shell/download.ts';
import { FileControl } from './FileControl.tsx';
import { Lines, type LinesProps } from './Lines.tsx';
import type { ParamProps } from './paramProps.ts';

/** Longer texts get a multiline field [characters]. */
const LONG = 60;

/** A text field; of a file with a choice of files. */
export function TextControl(props: ParamProps<TextParam>): ReactNode {
  const { spec, set, value, onChange } = props;
  const text = String(value);
  const long =
    spec.shader || spec.lines || [text, spec.default].some((words) => words.includes('\n') || words.length > LONG);
  if (spec.file) return <FileControl {...props} />;
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
