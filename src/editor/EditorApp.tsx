import { lazy, type ReactNode, Suspense, useEffect, useState } from 'react';
import { msg } from '../messages/message.ts';
import { useTexts } from './language/languageStore.ts';
import { projectName } from './projects/projectNames.ts';
import { useSaveProject } from './projects/useSaveProject.ts';
import { useSessionRecovery } from './projects/useSessionRecovery.ts';
import { DropZone } from './shell/DropZone.tsx';
import { Dock } from './shell/dock/Dock.tsx';
import { Header } from './shell/Header.tsx';
import { Notices } from './shell/Notices.tsx';
import { StatusBar } from './shell/StatusBar.tsx';
import { Timeline } from './shell/Timeline.tsx';
import { useSavePicture } from './shell/useSavePicture.ts';
import { useEditor, useEditorState } from './state/context.tsx';
import { isUnsaved } from './state/editor.ts';

/** Each is loaded when it is first opened. */
const DIALOGS = [
  { names: ['gallery'], Content: lazy(() => import('./shell/Gallery.tsx')) },
  { names: ['help'], Content: lazy(() => import('./shell/Help.tsx')) },
  { names: ['share', 'name'], Content: lazy(() => import('./projects/ProjectDialogs.tsx')) },
  { names: ['palette'], Content: lazy(() => import('./graph/search/CommandPalette.tsx')) },
] as const;

export function EditorApp(): ReactNode {
  const { t } = useTexts();
  usePageKeys();
  useSessionRecovery();
  useTitle();
  const toPicture = () => document.querySelector<HTMLElement>('[data-viewport]')?.focus();
  return (
    <div className="sl-app">
      <button type="button" className="sl-skip" onClick={toPicture}>
        {t(msg`Skip to the picture`)}
      </button>
      <Header />
      <main className="sl-main">
        <Dock />
      </main>
      <Timeline />
      <StatusBar />
      <Notices />
      <DropZone />
      {DIALOGS.map((dialog) => (
        <Dialog key={dialog.names[0]} {...dialog} />
      ))}
    </div>
  );
}

/** Sets the document title: the project's name, with a mark while it has unsaved changes. */
function useTitle(): void {
  const { t } = useTexts();
  const name = useEditorState(projectName);
  const unsaved = useEditorState(isUnsaved);
  useEffect(() => {
    document.title = [unsaved ? '•' : '', name, name && '–', t(msg`Slowlight`)].filter(Boolean).join(' ');
  }, [name, unsaved, t]);
}

/** A dialog, from when it is first opened. */
function Dialog({ names, Content }: (typeof DIALOGS)[number]): ReactNode {
  const asked = useEditorState(({ dialog }) => names.some((name) => name === dialog));
  const [wanted, setWanted] = useState(false);
  if (asked && !wanted) setWanted(true);
  return wanted ? (
    <Suspense>
      <Content />
    </Suspense>
  ) : null;
}

/** Keyboard shortcuts of the whole page; ignored while a text field has the focus. */
function usePageKeys(): void {
  const editor = useEditor();
  const savePicture = useSavePicture();
  const { save } = useSaveProject();
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      const command = event.ctrlKey || event.metaKey;
      const writing = event.target instanceof HTMLElement && event.target.matches('input:not([type=range]), textarea');
      if (event.key === 'F1' || (event.key === '?' && !writing)) editor.update({ dialog: 'help' });
      else if (command && (event.code === 'KeyK' || (event.code === 'KeyP' && event.shiftKey)))
        editor.update({ dialog: 'palette' });
      else if (command && event.code === 'KeyG' && event.shiftKey)
        editor.update({ graph: !editor.store.getState().graph });
      else if (command && event.code === 'KeyS') event.shiftKey ? void savePicture() : save();
      else if (command && event.code === 'KeyZ' && !writing) event.shiftKey ? editor.redo() : editor.undo();
      else if (command && event.code === 'KeyY' && !writing) editor.redo();
      else return;
      event.preventDefault();
    };
    addEventListener('keydown', onKey);
    return () => removeEventListener('keydown', onKey);
  }, [editor, savePicture, save]);
}
