import { PrecacheFallbackPlugin, precacheAndRoute } from 'workbox-precaching';
import { NavigationRoute, registerRoute } from 'workbox-routing';
import { NetworkOnly } from 'workbox-strategies';

declare const self: ServiceWorkerGlobalScope & {
  /** The page's files, as of this version: vite.config.ts. */
  readonly __WB_MANIFEST: Parameters<typeof precacheAndRoute>[0];
};

/** A network that gives no page in this time is taken for none [s]. */
const PATIENCE = 3;

/**
 * Pages come from the network where there is one: nobody has to ask for the newest version, and no other program at the
 * same address is hidden. Otherwise the page that was kept is opened. Registered before the files, of which it is one.
 */
registerRoute(
  new NavigationRoute(
    new NetworkOnly({
      networkTimeoutSeconds: PATIENCE,
      plugins: [new PrecacheFallbackPlugin({ fallbackURL: 'index.html' })],
    }),
    { denylist: [/\/api\//, /\/headless\.html$/] },
  ),
);

/**
 * A version's files stay until its last tab is closed, because a new version waits until then: an open tab always finds
 * the parts that it has not loaded yet.
 */
precacheAndRoute(self.__WB_MANIFEST);

/** Also the page that installed it finds its files here. */
self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()));
