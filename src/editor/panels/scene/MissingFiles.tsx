import { Button, Stack, Text } from '@mantine/core';
import { IconFilePlus } from '@tabler/icons-react';
import { type ReactNode, useRef } from 'react';
import { inEnglish, listed, msg } from '../../../messages/message.ts';
import type { Diagnostic } from '../../../scene/types.ts';
import { useTexts } from '../../language/languageStore.ts';
import { pickedFiles } from '../../loading/pickedFiles.ts';
import { useOpenFiles } from '../../shell/useOpenFiles.ts';
import { Section } from './Section.tsx';

/**
 * Files that the scene references and that were not found: what for, where they were searched, and a way to supply
 * them.
 */
export function MissingFiles({ notes }: { readonly notes: readonly Diagnostic[] }): ReactNode {
  const { t } = useTexts();
  const open = useOpenFiles();
  const input = useRef<HTMLInputElement>(null);
  const missing = notes.flatMap(({ place, missing: file }) => (file ? [{ place, ...file }] : []));
  if (missing.length === 0) return null;
  const onPicked = (picker: HTMLInputElement) => {
    open(pickedFiles(picker.files ?? []));
    picker.value = '';
  };
  return (
    <Section title={t(msg`Missing files`)}>
      <Stack gap="sm" component="ul" className="sl-list">
        {missing.map(({ name, place, lookedFor }) => (
          <Stack gap={2} component="li" key={`${name} ${inEnglish(place)}`} data-missing={name}>
            <Text size="sm" fw={600} className="sl-place">
              {name}
            </Text>
            <Text size="xs" className="sl-place">
              {t(msg`for ${place}`)}
            </Text>
            <Text size="xs" c="dimmed" className="sl-place">
              {t(msg`searched ${listed(lookedFor)}`)}
            </Text>
          </Stack>
        ))}
      </Stack>
      <Button
        size="xs"
        variant="light"
        className="sl-remedy"
        leftSection={<IconFilePlus size={15} />}
        onClick={() => input.current?.click()}
      >
        {t(msg`Add missing files…`)}
      </Button>
      <Text size="xs" c="dimmed">
        {t(msg`Or drop them on the page. The scene is then reloaded; you stay where you are.`)}
      </Text>
      <input ref={input} type="file" multiple hidden onChange={(event) => onPicked(event.currentTarget)} />
    </Section>
  );
}
