/** How the fragment of a link to a project begins. */
export const FRAGMENT_PREFIX = 'project=';

export const withoutHash = (fragment: string): string => fragment.replace(/^#/, '');

/** Whether a page's fragment is a link to a project, which `shareLink.ts` reads. */
export const isShareLink = (fragment: string): boolean => withoutHash(fragment).startsWith(FRAGMENT_PREFIX);
