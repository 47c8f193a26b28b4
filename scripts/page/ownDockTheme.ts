import type { Plugin } from 'vite';

/** Themes of the dock, and parts that this page's dock does not have: floating groups, pane views, pinned and grouped tabs, menus of tabs. */
const UNUSED_OF_DOCK =
  /dockview-theme-|\.dv-(?:pane|pinned|debug|floating-titlebar|resize-container|edge-peek|context-menu|tab-group-chip)/;

/** Dockview ships all its themes and parts in one sheet; the page has a theme of its own, and few of the parts. */
export function ownDockTheme(): Plugin {
  return {
    name: 'slowlight-own-dock-theme',
    transform(code, id) {
      if (!/dockview\.css/.test(id)) return undefined;
      const rules = code.match(/[^{}]*\{(?:[^{}]|\{[^{}]*\})*\}/g) ?? [];
      const isUnused = (rule: string): boolean =>
        rule
          .replace(/\/\*.*?\*\//gs, '')
          .split('{')[0]!
          .split(',')
          .every((selector) => UNUSED_OF_DOCK.test(selector));
      return rules.filter((rule) => !isUnused(rule)).join('');
    },
  };
}
