import { createStore } from 'zustand/vanilla';

/** The browser's offer to install the page; of Chromium only: other browsers have it in their own menus. */
interface InstallPromptEvent extends Event {
  /** Asks the user; only once. */
  prompt(): Promise<unknown>;
}

/** Installs the page as a program; absent where the browser does not offer it, or no longer. */
export const installStore = createStore<{ readonly install?: (() => void) | undefined }>(() => ({}));

/** The browser may offer it before there is a picture. */
export function listenForInstallPrompt(): void {
  addEventListener('beforeinstallprompt', (event) => {
    // The page's menu offers it, not a bar over the picture.
    event.preventDefault();
    const install = (): void => {
      installStore.setState({ install: undefined });
      void (event as InstallPromptEvent).prompt();
    };
    installStore.setState({ install });
  });
  addEventListener('appinstalled', () => installStore.setState({ install: undefined }));
}
