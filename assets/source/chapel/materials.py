"""The glTF materials: which textures, how many metres one repeat covers, and what they are made of."""

AO = "textures/ambient_occlusion.png"
LIT_BY_SUN, LIT_BY_SKY = 3000.0, 1500.0  # luminance in cd/m2 behind clear glass


def textured(name, tile, normal_scale=1.0, ao=True, double_sided=False):
    return dict(tile=tile, maps=name, normal_scale=normal_scale, ao=ao, double_sided=double_sided)


MATERIALS = {
    "ashlar": textured("ashlar", (4.0, 4.0)),
    "outside": textured("ashlar", (4.0, 4.0), ao=False),
    "dressed": textured("dressed", (2.0, 2.0)),
    "web": textured("web", (2.4, 2.4)),
    "flagstone": textured("flagstone", (3.0, 3.0)),
    "oak": textured("oak", (2.4, 0.8)),
    "roof": dict(tile=(1, 1), base=(.06, .05, .045, 1), roughness=.9, metallic=0, double_sided=True),
    "iron": textured("iron", (0.5, 0.5), ao=False),
    "brass": dict(tile=(1, 1), base=(.78, .57, .28, 1), roughness=.34, metallic=1),
    "wax": dict(tile=(1, 1), base=(.83, .74, .58, 1), roughness=.45, metallic=0),
    "linen": textured("linen", (0.5, 0.5), ao=True, double_sided=True),
    "brocade": textured("brocade", (1.0, 1.0), ao=False, double_sided=True),
    "flame": dict(tile=(1, 1), base=(0, 0, 0, 1), roughness=1, metallic=0, emissive=(1.0, .55, .18), strength=5000.0, double_sided=True),
    "water": dict(tile=(1, 1), base=(.035, .05, .045, 1), roughness=.03, metallic=0, transmission=.9, ior=1.33, normal="textures/water_normal.png"),
}

DESIGNS = ["a", "b", "c", "east", "rose"]
for _design in DESIGNS:
    for _lit, _strength, _tint in (("sun", LIT_BY_SUN, (1.0, .97, .92)), ("sky", LIT_BY_SKY, (.80, .93, 1.0))):
        MATERIALS[f"glass_{_design}_{_lit}"] = dict(tile=(1, 1), glass=f"textures/glass_{_design}.jpg", strength=_strength, emissive=_tint,
                                                    roughness=.25, metallic=0, double_sided=True)
