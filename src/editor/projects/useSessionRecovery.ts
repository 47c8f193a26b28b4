import { useCallback, useEffect, useRef } from 'react';
import { isShareLink } from '../../graph/document/shareFragment.ts';
import { LANGUAGES, type LanguageTag } from '../../messages/languages.ts';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { useTexts } from '../language/languageStore.ts';
import { useServices } from '../services.tsx';
import { useEditor } from '../state/context.tsx';
import { linkErrorOf, openErrorOf } from './projectSource.ts';
import { restoreSession } from './restoreSession.ts';
import type { SessionRecord } from './sessionStore.ts';
import { projectFromLink } from './startup.ts';

/**
 * Reports what cannot be stored, offers the session of a closed tab, and opens project links that are followed within
 * the page.
 */
export function useSessionRecovery(): void {
  const { language } = useTexts();
  const editor = useEditor();
  const { autosave, sessions } = useServices();
  const resume = useRestoreSession();
  useEffect(() => {
    autosave.onFailure = (unkept) => {
      const text =
        unkept.kind === 'work'
          ? msg`This browser cannot store your work (${unkept.why}): unsaved changes are lost when the page is closed. Save the project, or free some storage.`
          : msg`The files (${unkept.size}) are too large to be stored in the browser. After a reload they must be opened again; everything else is kept.`;
      editor.notify({ kind: 'error', text });
    };
  }, [editor, autosave]);

  const when = useRef((at: number) => new Date(at).toLocaleString());
  when.current = (at) => formatTime(at, language);
  useEffect(() => {
    if (!sessions || autosave.isRestored) return;
    const offer = async (): Promise<void> => {
      const [latest] = (await sessions.closedSessions()).filter(({ unsaved, passed }) => unsaved && !passed);
      if (!latest) return;
      // Offered once; after that it is in the menu only.
      await sessions.save({ ...latest, passed: true });
      const text = msg`There is unsaved work from ${when.current(latest.at)}: ${latest.name}.`;
      const action = { text: msg`Restore`, act: () => resume(latest) };
      editor.notify({ kind: 'info', text, action });
    };
    offer().catch((error: unknown) => autosave.onFailure({ kind: 'work', why: messageOf(error) }));
  }, [editor, autosave, sessions, resume]);

  useEffect(() => {
    const onFollowed = (): void => {
      if (!isShareLink(location.hash)) return;
      projectFromLink(location.hash)
        .then(editor.openProject)
        .catch((error: unknown) => editor.notify({ kind: 'error', ...linkErrorOf(error) }));
    };
    addEventListener('hashchange', onFollowed);
    return () => removeEventListener('hashchange', onFollowed);
  }, [editor]);
}

export const formatTime = (at: number, language: LanguageTag): string =>
  new Date(at).toLocaleString(LANGUAGES[language].locale, { dateStyle: 'medium', timeStyle: 'short' });

/** Restores the session of a closed tab into this one. */
export function useRestoreSession(): (session: SessionRecord) => void {
  const editor = useEditor();
  const { autosave, sessions, localFiles } = useServices();
  return useCallback(
    (session) => {
      const resumed = async (): Promise<void> => {
        if (!sessions) return;
        editor.openProject(restoreSession(session, await sessions.filesOf(session.id), localFiles));
        if (await autosave.saveNow()) await sessions.delete(session.id);
      };
      resumed().catch((error: unknown) => editor.notify({ kind: 'error', ...openErrorOf(session.name, error) }));
    },
    [editor, autosave, sessions, localFiles],
  );
}
