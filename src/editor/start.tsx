import { LANGUAGES } from '../messages/languages.ts';
import { msg } from '../messages/message.ts';
import '@fontsource-variable/inter/wght.css';
import './fonts/fonts.css';
import './mantine.css';
import './editor.css';
import { MantineProvider } from '@mantine/core';
import { type ReactNode, StrictMode, useEffect } from 'react';
import type { Root } from 'react-dom/client';
import type { LessonPlace } from '../lessons/lessonAddress.ts';
import type { Backend } from '../render/settings.ts';
import { EditorApp } from './EditorApp.tsx';
import { isCoarse } from './flight/inputDevice.ts';
import { ObserverController } from './flight/observerController.ts';
import { setLanguage, useTexts } from './language/languageStore.ts';
import { readFont } from './loading/fonts.ts';
import { LocalFiles } from './loading/localFiles.ts';
import { fileReader, sceneReader } from './loading/sceneLoader.ts';
import { listenForInstallPrompt } from './offline/installPrompt.ts';
import { renderStillInWorker } from './pipelines/renderStill.ts';
import { Autosave } from './projects/autosave.ts';
import { openStartupProject, pageAddress, type StartupRequest } from './projects/startup.ts';
import { type EditorServices, ServicesProvider } from './services.tsx';
import { EditorProvider } from './state/context.tsx';
import { createEditor } from './state/editor.ts';
import { loadPreferences, prefersReducedMotion } from './state/preferences.ts';
import { telemetry } from './state/telemetry.ts';
import { theme } from './theme.ts';
import { chooseBackend } from './viewport/chooseBackend.ts';
import { legendStore } from './viewport/legend/legendState.ts';

export interface StartOptions extends StartupRequest {
  readonly backend: Backend | 'auto';
  readonly lesson: LessonPlace | undefined;
}

/** Starts the editor in a page. */
export async function startEditor(root: Root, { backend: wanted, lesson, ...asked }: StartOptions): Promise<void> {
  if (isCoarse) void import('./coarse.css');
  listenForInstallPrompt();
  const { language, legend: withLegend, flight, comfort, frameRate } = loadPreferences();
  legendStore.setState({ visible: withLegend });
  const [backend] = await Promise.all([chooseBackend(wanted), setLanguage(language).catch(() => setLanguage('en'))]);
  if (!backend) {
    const { Unsupported } = await import('./shell/Unsupported.tsx');
    root.render(
      <Page>
        <Unsupported />
      </Page>,
    );
    return;
  }
  const localFiles = new LocalFiles();
  const readScene = sceneReader(localFiles);
  const { project, view, problem, ...session } = await openStartupProject(asked, localFiles);
  const playing = view?.playing ?? !prefersReducedMotion();
  const editor = createEditor({
    services: {
      readScene,
      readFont,
      readFile: fileReader(localFiles),
      renderStill: renderStillInWorker,
      openGpu: async () => (await import('../compute/computeDevice.ts')).openWebGpu(),
    },
    project,
    playing,
  });
  if (view) editor.update({ loop: view.loop });
  editor.update({ lesson, frameRate });
  if (problem) editor.notify({ kind: 'error', ...problem });
  const observerController = new ObserverController(editor, view);
  if (flight) void import('./flight/deck/openDeck.ts').then(({ openDeck }) => openDeck(editor, observerController));
  const loadComfort = (): void =>
    void import('./flight/comfort/comfort.ts').then(({ openComfort }) => openComfort(editor, observerController));
  if (comfort) loadComfort();
  // Who wishes reduced motion needs it when he flies, not before the first picture.
  else if (prefersReducedMotion()) {
    for (const input of ['keydown', 'pointerdown']) addEventListener(input, loadComfort, { once: true });
    // A ridden camera moves by itself.
    const stop = editor.store.subscribe(({ picture }) => {
      if (!picture?.ride) return;
      stop();
      loadComfort();
    });
  }
  const stopWaiting = telemetry.subscribe(({ drawn }) => {
    if (!drawn) return;
    stopWaiting();
    void import('./offline/keepForOffline.ts').then(({ keepForOffline }) => keepForOffline());
  });
  const autosave = new Autosave({ ...session, editor, observerController, localFiles, address: pageAddress });
  // A duplicated tab has nothing stored yet.
  void autosave.saveNow();
  const sessions = 'refusal' in session.sessions ? undefined : session.sessions;
  const services: EditorServices = { observerController, localFiles, backend, viewport: {}, autosave, sessions };
  root.render(
    <Page>
      <EditorProvider value={editor}>
        <ServicesProvider value={services}>
          <EditorApp />
        </ServicesProvider>
      </EditorProvider>
    </Page>,
  );
}

function Page({ children }: { readonly children: ReactNode }): ReactNode {
  return (
    <StrictMode>
      <MantineProvider theme={theme} defaultColorScheme="auto">
        <Language />
        {children}
      </MantineProvider>
    </StrictMode>
  );
}

/** Sets the document's language, for screen readers and font selection. */
function Language(): null {
  const { t, language } = useTexts();
  useEffect(() => {
    document.documentElement.lang = LANGUAGES[language].locale;
    document.title = t(msg`Slowlight`);
  }, [language, t]);
  return null;
}
