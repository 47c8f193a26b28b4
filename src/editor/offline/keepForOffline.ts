/**
 * Lets the browser keep the page and its examples, so that they open without a network; not where the user saves data,
 * nor where the browser refuses: the page works as before.
 */
export async function keepForOffline(): Promise<void> {
  if (!navigator.serviceWorker || savesData()) return;
  try {
    await navigator.serviceWorker.register(new URL('serviceWorker.js', document.baseURI));
  } catch (error) {
    console.warn('Slowlight is not kept for use without a network:', error);
  }
}

/** Whether the user asks for little traffic; only some browsers tell. */
const savesData = (): boolean =>
  (navigator as { readonly connection?: { readonly saveData?: boolean } }).connection?.saveData === true;
