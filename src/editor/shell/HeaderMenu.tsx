import { ActionIcon, Menu, useComputedColorScheme, useMantineColorScheme } from '@mantine/core';
import { IconDots } from '@tabler/icons-react';
import type { ReactNode } from 'react';
import { LANGUAGE_TAGS, LANGUAGES } from '../../messages/languages.ts';
import { msg } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { useChangeLanguage } from '../language/useChangeLanguage.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import { useSavePicture } from './useSavePicture.ts';

/** What the header has besides scenes, project and undo, where it is narrow and touched (coarse.css). */
export default function HeaderMenu(): ReactNode {
  const { t, language } = useTexts();
  const editor = useEditor();
  const save = useSavePicture();
  const change = useChangeLanguage();
  const graph = useEditorState((state) => state.graph);
  const { setColorScheme } = useMantineColorScheme();
  const other = useComputedColorScheme('dark') === 'dark' ? 'light' : 'dark';
  return (
    <Menu position="bottom-end">
      <Menu.Target>
        <ActionIcon variant="subtle" color="gray" className="sl-header-menu" aria-label={t(msg`More`)}>
          <IconDots size={20} />
        </ActionIcon>
      </Menu.Target>
      <Menu.Dropdown>
        <Menu.Item onClick={() => void save()}>{t(msg`Save picture`)}</Menu.Item>
        <Menu.Item onClick={() => editor.update({ graph: !graph })}>
          {t(graph ? msg`Hide the node graph` : msg`Show the node graph`)}
        </Menu.Item>
        <Menu.Item onClick={() => setColorScheme(other)}>
          {t(other === 'dark' ? msg`Dark colours` : msg`Light colours`)}
        </Menu.Item>
        {LANGUAGE_TAGS.filter((tag) => tag !== language).map((tag) => (
          <Menu.Item key={tag} lang={LANGUAGES[tag].locale} onClick={() => change(tag)}>
            {LANGUAGES[tag].name}
          </Menu.Item>
        ))}
        <Menu.Item onClick={() => editor.update({ dialog: 'help' })}>{t(msg`Keys and help`)}</Menu.Item>
      </Menu.Dropdown>
    </Menu>
  );
}
