import { createContext, useContext } from 'react';
import type { Backend } from '../render/settings.ts';
import type { ObserverController } from './flight/observerController.ts';
import type { LocalFiles } from './loading/localFiles.ts';
import type { Autosave } from './projects/autosave.ts';
import type { SessionStore } from './projects/sessionStore.ts';
import type { CapturedPicture, PreviewContext } from './viewport/viewportRenderer.ts';

/** Services that components share, besides the editor's state. */
export interface EditorServices {
  readonly observerController: ObserverController;
  readonly localFiles: LocalFiles;
  readonly autosave: Autosave;
  /** Stored sessions; undefined if the browser provides no storage. */
  readonly sessions: SessionStore | undefined;
  readonly backend: Backend | 'auto';
  /** The viewport's current renderer, while it exists: for saving its picture, and for node pictures. */
  readonly viewport: {
    capture?: () => Promise<CapturedPicture | undefined>;
    besides?: () => PreviewContext | undefined;
  };
}

const ServicesContext = createContext<EditorServices | undefined>(undefined);
export const ServicesProvider = ServicesContext.Provider;

export function useServices(): EditorServices {
  const services = useContext(ServicesContext);
  if (!services) throw new Error('no ServicesProvider above this component');
  return services;
}
