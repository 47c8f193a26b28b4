import '@fontsource-variable/inter/wght.css';
import './fonts/fonts.css';
import './mantine.css';
import 'dockview/dist/styles/dockview.css';
import './editor.css';
import './viewport/legend.css';
import { MantineProvider } from '@mantine/core';
import { type ReactNode, StrictMode, useEffect } from 'react';
import type { Root } from 'react-dom/client';
import { openWebGpu } from '../compute/gpu.ts';
import type { Backend } from '../render/settings.ts';
import { Editor } from './Editor.tsx';
import { startTranslation, useTexts } from './i18n/i18n.ts';
import { readFont } from './loading/fonts.ts';
import { LocalFiles } from './loading/localFiles.ts';
import { fileReader, sceneReader } from './loading/sceneLoader.ts';
import { Autosave } from './projects/autosave.ts';
import { begin, pageAddress, type Wanted } from './projects/beginning.ts';
import { type EditorServices, ServicesProvider } from './services.tsx';
import { Unsupported } from './shell/Unsupported.tsx';
import { StudioProvider } from './state/context.tsx';
import { legend } from './state/legend.ts';
import { loadPreferences, prefersReducedMotion } from './state/preferences.ts';
import { createStudio } from './state/studio.ts';
import { theme } from './theme.ts';
import { traceInWorkers } from './tracing/tracing.ts';
import { chooseGraphics } from './viewport/graphics.ts';
import { Pilot } from './viewport/pilot.ts';

export interface StartOptions extends Wanted {
  readonly backend: Backend | 'auto';
}

/** Puts the program on a page. */
export async function startEditor(root: Root, { backend: wanted, ...asked }: StartOptions): Promise<void> {
  const { language, legend: withLegend } = loadPreferences();
  legend.setState({ shown: withLegend });
  const [backend] = await Promise.all([chooseGraphics(wanted), startTranslation(language)]);
  if (!backend) {
    root.render(
      <Page>
        <Unsupported />
      </Page>,
    );
    return;
  }
  const localFiles = new LocalFiles();
  const readScene = sceneReader(localFiles);
  const { beginning, view, problem, ...session } = await begin(asked, localFiles);
  const playing = view?.playing ?? !prefersReducedMotion();
  const studio = createStudio({
    services: { readScene, readFont, readFile: fileReader(localFiles), trace: traceInWorkers, openGpu: openWebGpu },
    beginning,
    playing,
  });
  if (view) studio.change({ loop: view.loop });
  if (problem) studio.notify({ kind: 'error', ...problem });
  const pilot = new Pilot(studio, view);
  const autosave = new Autosave({ ...session, studio, pilot, localFiles, address: pageAddress });
  // A tab that is a copy of another has nothing of its own yet.
  void autosave.now();
  const sessions = 'refusal' in session.sessions ? undefined : session.sessions;
  const services: EditorServices = { pilot, localFiles, backend, stage: {}, autosave, sessions };
  root.render(
    <Page>
      <StudioProvider value={studio}>
        <ServicesProvider value={services}>
          <Editor />
        </ServicesProvider>
      </StudioProvider>
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

/** Tells the browser, and with it screen readers and fonts, what language the page is in. */
function Language(): null {
  const { t, language } = useTexts();
  useEffect(() => {
    document.documentElement.lang = language === 'zh' ? 'zh-CN' : 'en';
    document.title = t('app.title');
  }, [language, t]);
  return null;
}
