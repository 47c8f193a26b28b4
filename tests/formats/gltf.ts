import { EXTMeshGPUInstancing } from '@gltf-transform/extensions';
import { expect } from 'vitest';
import { MAX_SPHERES } from '../../src/formats/read/strands/pointSpheres.ts';
import { vertexPosition } from '../../src/scene/motion/motion.ts';
import { find } from '../support/gltfBuilder.ts';
import { dracoGlb, meshoptGlb } from '../support/gltfCompress.ts';
import { approximated, type ClaimGroup, type Files, leftOut, read, refused } from './claim.ts';
import { glb, json, packed, triangles } from './gltfExamples.ts';
import { materialGroups } from './gltfMaterials.ts';
import { C } from './usdKit.ts';

/** A file whose compressed data are zeros. */
async function damaged(): Promise<Files> {
  const glb = (await packed('KHR_draco_mesh_compression', (doc) => dracoGlb(doc, 'edgebreaker'))())[
    'a.glb'
  ] as Uint8Array;
  const start = 20 + new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  return { 'a.glb': Uint8Array.from(glb).fill(0, start + 8) };
}

const files: ClaimGroup = {
  title: 'Files',
  rows: [
    read(
      '`.glb`, and `.gltf` with `.bin` and pictures beside it or embedded',
      'a scene in metres, Y up',
      json({}),
      triangles(1),
    ),
    read(
      '`KHR_draco_mesh_compression`',
      'decompressed',
      packed('KHR_draco_mesh_compression', (doc) => dracoGlb(doc, 'edgebreaker')),
      triangles(1),
    ),
    read(
      '`EXT_meshopt_compression`, `KHR_meshopt_compression`, `KHR_mesh_quantization`',
      'decompressed',
      packed('EXT_meshopt_compression', (doc) => meshoptGlb(doc, 'filter')),
      triangles(1),
    ),
    read(
      '`extras.slowlight` of the scene: `speedOfLight`, `title`, `lookFor`, `beta`, `openAt`',
      'the author’s suggestions for viewing',
      json({ scenes: [{ nodes: [0], extras: { slowlight: { speedOfLight: 10, title: 'Street' } } }] }),
      (s) => expect(s.hints).toEqual({ speedOfLight: 10, title: 'Street' }),
    ),
    read(
      'a later version 2, unless its `minVersion` is later, too',
      'as 2.0',
      json({ asset: { version: '2.1' } }),
      triangles(1),
    ),
    leftOut(
      'every other extension that is not required, or affects only appearance',
      'reported',
      'gltf.ignored-extension',
      [
        json({ extensionsUsed: ['EXT_new'] }),
        json({
          extensionsUsed: ['KHR_materials_diffuse_transmission'],
          extensionsRequired: ['KHR_materials_diffuse_transmission'],
        }),
      ],
      triangles(1),
    ),
    refused(
      'an unsupported required extension that affects more than appearance',
      'with its name',
      'gltf.unsupported-extension',
      json({ extensionsUsed: ['EXT_new'], extensionsRequired: ['EXT_new'] }),
    ),
    refused('glTF 1, or what needs more than 2.0', 'with its version', 'gltf.version', [
      json({ asset: { version: '1.0' }, nodes: { Thing: {} } }),
      json({ asset: { version: '2.1', minVersion: '2.1' } }),
    ]),
    refused('damaged JSON', 'with the location', 'gltf.damaged', { 'a.gltf': '{' }),
    refused('JSON that violates the schema', 'with location and value', 'gltf.invalid', json({ nodes: {} })),
    refused(
      'a truncated file or buffer',
      'with the actual and the expected amount',
      'gltf.truncated',
      json({ buffers: [{ byteLength: 40, uri: 'a.bin' }] }),
    ),
    refused('a missing buffer', 'with its name', 'gltf.missing-file', { 'a.gltf': json({})['a.gltf'] }),
    refused('an index out of range', 'with location and number', 'gltf.bad-reference', json({ nodes: [{ mesh: 7 }] })),
    refused(
      'an accessor of an unknown type',
      'with the type',
      'gltf.bad-accessor',
      json({ accessors: [{ bufferView: 0, componentType: 1, count: 3, type: 'VEC3' }] }),
    ),
    refused('compressed data that cannot be decompressed', 'with the reason', 'gltf.draco', damaged),
    refused(
      'a byte range outside the buffer',
      'with the location',
      'gltf.out-of-range',
      json({ bufferViews: [{ buffer: 0, byteLength: 36, byteOffset: 4 }] }),
    ),
    refused(
      'nodes in a cycle, or with two parents',
      'with the node',
      'gltf.bad-tree',
      json({ nodes: [{ mesh: 0, children: [0] }] }),
    ),
    refused(
      'more objects, vertices or bytes than the limit for a scene',
      'with the number',
      'gltf.too-large',
      json({ accessors: [{ componentType: 5126, count: 2 ** 30, type: 'VEC3' }] }),
    ),
  ],
};

const shapes: ClaimGroup = {
  title: 'Nodes and shapes',
  rows: [
    read(
      'nodes, with translation, rotation, scale or a matrix (also with shear)',
      'one object per node with a mesh: `/Parent/Child`, or `/Parent/Child/Mesh` if the node has other contents',
      glb((_, thing) => thing.setTranslation([1, 2, 3])),
      (s) => expect(vertexPosition(find(s, '/Thing'), 0, 0, C)).toEqual([1, 2, 3]),
    ),
    read(
      'triangles, strips, fans; several primitives',
      'one mesh with a range of triangles per material; flat shading without normals',
      ([5, 6] as const).map((mode) =>
        glb((kit, thing) => {
          thing.getMesh()!.addPrimitive(kit.triangle([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]).setMode(mode));
        }),
      ),
      triangles(3),
    ),
    read(
      'sparse accessors',
      'with their substituted values',
      json({
        accessors: [
          {
            componentType: 5126,
            count: 3,
            type: 'VEC3',
            sparse: {
              count: 1,
              indices: { bufferView: 1, componentType: 5123 },
              values: { bufferView: 0, byteOffset: 12 },
            },
          },
        ],
        bufferViews: [
          { buffer: 0, byteLength: 36 },
          { buffer: 0, byteLength: 2 },
        ],
      }),
      (s) => expect([...find(s, '/Thing').mesh.positions.subarray(0, 3)]).toEqual([1, 0, 0]),
    ),
    read(
      '`EXT_mesh_gpu_instancing`',
      'one object per instance: `/Node/Instance0`',
      glb((kit, thing) => {
        const of = kit.doc.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
        thing.setExtension(
          'EXT_mesh_gpu_instancing',
          of.setAttribute('TRANSLATION', kit.values('VEC3', [0, 0, 0, 5, 0, 0])),
        );
      }),
      (s) => expect(s.objects.map((o) => o.path)).toEqual(['/Thing/Instance0', '/Thing/Instance1']),
    ),
    read(
      '`KHR_node_visibility`',
      'hidden nodes are not shown',
      json({
        extensionsUsed: ['KHR_node_visibility'],
        scenes: [{ nodes: [0, 1] }],
        nodes: [
          { name: 'Thing', mesh: 0 },
          { mesh: 0, extensions: { KHR_node_visibility: { visible: false } } },
        ],
      }),
      (s) => expect(s.objects.length).toBe(1),
    ),
    read(
      'points; separate lines, strips and loops, with vertex colours, morph targets and joints',
      'spheres of 8 to 512 triangles, a 250th of the scene’s size across, and tubes half as wide with 3 to 8 sides; thinner where their mesh is small. Unlit without normals',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle().setMode(0)).addPrimitive(kit.triangle().setMode(2));
      }),
      // 3 spheres; 3 × 8 quadrilaterals and 4 lids of 2 tubes, which meet where the loop turns back.
      triangles(1 + 3 * 512 + 3 * 8 * 2 + 4 * 6),
      { says: 'gltf.primitive' },
    ),
    approximated(
      'too many points or lines in a file',
      'one in so many is drawn',
      'gltf.primitive',
      glb((kit, thing) => {
        const many = new Array(3 * (MAX_SPHERES + 1)).fill(0);
        thing.getMesh()!.addPrimitive(kit.triangle(many).setMode(0));
      }),
      triangles(1 + 8 * (MAX_SPHERES / 2 + 1)),
    ),
    leftOut(
      'instance attributes other than translation, rotation and scale',
      'reported',
      'gltf.instance-attributes',
      glb((kit, thing) => {
        const of = kit.doc.createExtension(EXTMeshGPUInstancing).createInstancedMesh();
        of.setAttribute('TRANSLATION', kit.values('VEC3', [0, 0, 0])).setAttribute(
          '_COLOR',
          kit.values('VEC3', [1, 0, 0]),
        );
        thing.setExtension('EXT_mesh_gpu_instancing', of);
      }),
    ),
    approximated(
      'single-sided and double-sided materials on one mesh',
      'the whole mesh is double-sided',
      'gltf.mixed-sides',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle().setMaterial(kit.doc.createMaterial().setDoubleSided(true)));
      }),
      (s) => expect(find(s, '/Thing').mesh.doubleSided).toBe(true),
    ),
    refused(
      'a triangle with a vertex index out of range',
      'with the number',
      'gltf.bad-index',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle().setIndices(kit.ints('SCALAR', [0, 1, 7])));
      }),
    ),
    refused(
      'an attribute with too few values',
      'with the numbers',
      'gltf.bad-attribute',
      glb((kit, thing) => {
        thing.getMesh()!.addPrimitive(kit.triangle().setAttribute('NORMAL', kit.values('VEC3', [0, 0, 1])));
      }),
    ),
  ],
};

export const gltfGroups: readonly ClaimGroup[] = [files, shapes, ...materialGroups];
