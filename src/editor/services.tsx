import { createContext, useContext } from 'react';
import type { Backend } from '../render/settings.ts';
import type { LocalFiles } from './loading/localFiles.ts';
import type { Autosave } from './projects/autosave.ts';
import type { Sessions } from './projects/sessions.ts';
import type { Pilot } from './viewport/pilot.ts';
import type { Besides, Captured } from './viewport/stage.ts';

/** What the components share besides the studio's state. */
export interface EditorServices {
  readonly pilot: Pilot;
  readonly localFiles: LocalFiles;
  readonly autosave: Autosave;
  /** What is kept of this tab and others; undefined where the browser keeps nothing. */
  readonly sessions: Sessions | undefined;
  readonly backend: Backend | 'auto';
  /** The stage on show, as long as there is one: for saving its picture, and for pictures of nodes. */
  readonly stage: { capture?: () => Promise<Captured | undefined>; besides?: () => Besides | undefined };
}

const ServicesContext = createContext<EditorServices | undefined>(undefined);
export const ServicesProvider = ServicesContext.Provider;

export function useServices(): EditorServices {
  const services = useContext(ServicesContext);
  if (!services) throw new Error('no ServicesProvider above this component');
  return services;
}
