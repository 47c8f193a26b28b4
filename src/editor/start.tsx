import '@fontsource-variable/inter/wght.css';
import '@mantine/core/styles.css';
import 'dockview/dist/styles/dockview.css';
import './editor.css';
import './viewport/legend.css';
import { MantineProvider } from '@mantine/core';
import { type ReactNode, StrictMode, useEffect } from 'react';
import type { Root } from 'react-dom/client';
import type { Backend } from '../render/settings.ts';
import { Editor } from './Editor.tsx';
import { startTranslation, useTexts } from './i18n/i18n.ts';
import { fileReader, LocalFiles, sceneReader } from './loading/sceneLoader.ts';
import { type EditorServices, ServicesProvider } from './services.tsx';
import { Unsupported } from './shell/Unsupported.tsx';
import { StudioProvider } from './state/context.tsx';
import { legend } from './state/legend.ts';
import { loadPreferences, prefersReducedMotion } from './state/preferences.ts';
import { createStudio } from './state/studio.ts';
import { theme } from './theme.ts';
import { chooseGraphics } from './viewport/graphics.ts';
import { Pilot } from './viewport/pilot.ts';

export interface StartOptions {
  /** Address of the scene to begin with. */
  readonly source: string;
  readonly backend: Backend | 'auto';
}

/** Puts the program on a page. */
export async function startEditor(root: Root, { source, backend: wanted }: StartOptions): Promise<void> {
  const { language, legend: withLegend } = loadPreferences();
  await startTranslation(language);
  legend.setState({ shown: withLegend });
  const backend = await chooseGraphics(wanted);
  if (!backend) {
    root.render(
      <Page>
        <Unsupported />
      </Page>,
    );
    return;
  }
  const localFiles = new LocalFiles();
  const files = { readScene: sceneReader(localFiles), readFile: fileReader(localFiles) };
  const studio = createStudio({ services: files, source, playing: !prefersReducedMotion() });
  const services: EditorServices = { pilot: new Pilot(studio), localFiles, backend, stage: {} };
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
