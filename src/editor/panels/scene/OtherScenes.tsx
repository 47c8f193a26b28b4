import { Select } from '@mantine/core';
import type { ReactNode } from 'react';
import { scenesIn } from '../../../formats/entry.ts';
import { msg } from '../../../messages/message.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useServices } from '../../services.tsx';
import { useEditor } from '../../state/context.tsx';

/** The other scenes of the opened archive or folder, if any. */
export function OtherScenes({ source }: { readonly source: string }): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const { localFiles } = useServices();
  const given = localFiles.get(source);
  const scenes = given && given.base === undefined ? scenesIn(localFiles.paths(source)) : [];
  if (!given || scenes.length < 2) return null;
  return (
    <Select
      size="xs"
      label={t(msg`Scene in these files`)}
      searchable={scenes.length > 8}
      allowDeselect={false}
      limit={100}
      value={given.entry}
      data={scenes.includes(given.entry) ? scenes : [given.entry, ...scenes]}
      onChange={(entry) => entry && entry !== given.entry && editor.open(localFiles.sibling(source, entry))}
    />
  );
}
