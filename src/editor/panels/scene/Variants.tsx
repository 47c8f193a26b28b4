import { Select } from '@mantine/core';
import type { ReactNode } from 'react';
import { formatVariantChoice } from '../../../formats/variantChoice.ts';
import { msg } from '../../../messages/message.ts';
import { nearestToOutput } from '../../../nodes/project/outputChain.ts';
import type { VariantSet } from '../../../scene/types.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditor, useEditorState } from '../../state/context.tsx';
import { Section } from './Section.tsx';

/** Variant sets of the file. Selecting one reloads the scene; the observer stays in place. */
export function Variants({ sets }: { readonly sets: readonly VariantSet[] }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const reader = useEditorState(({ history }) => nearestToOutput(history.document, 'read'));
  const set = reader?.params.variants;
  const chosen: readonly string[] = Array.isArray(set) ? set.map(String) : [];
  if (!reader || sets.length === 0) return null;
  const choose = (name: string, option: string | null) => {
    const others = chosen.filter((text) => !text.startsWith(formatVariantChoice(name, '')));
    const next = option ? [...others, formatVariantChoice(name, option)] : others;
    editor.set(reader.id, 'variants', next.length > 0 ? next : undefined, msg`choose a variant`);
  };
  return (
    <Section title={t(msg`Variants`)}>
      {sets.map((one) => (
        <VariantSelect
          key={one.set}
          set={one}
          chosen={chosen.find((text) => text.startsWith(formatVariantChoice(one.set, '')))?.slice(one.set.length + 1)}
          onChoose={(option) => choose(one.set, option)}
        />
      ))}
    </Section>
  );
}

interface VariantSelectProps {
  readonly set: VariantSet;
  /** The user's selection; undefined: the file's own applies. */
  readonly chosen: string | undefined;
  readonly onChoose: (option: string | null) => void;
}

function VariantSelect({ set: { set, options, chosen: shown }, chosen, onChoose }: VariantSelectProps): ReactNode {
  const { t } = useTexts();
  const [, path, name] = /^(.*)\{(.*)\}$/.exec(set) ?? ['', '', set];
  return (
    <Select
      size="xs"
      label={name}
      description={path}
      searchable={options.length > 12}
      allowDeselect={false}
      clearable={chosen !== undefined}
      clearButtonProps={{ 'aria-label': t(msg`Back to the default`) }}
      placeholder={t(msg`none`)}
      value={chosen ?? (shown || null)}
      data={[...options]}
      onChange={onChoose}
    />
  );
}
