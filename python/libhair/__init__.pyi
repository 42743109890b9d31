"""Written by write_stubs.py; do not edit."""

from . import _libhair as _libhair
from ._libhair import __version__ as __version__
from ._libhair import BindSettings as BindSettings
from ._libhair import Candidate as Candidate
from ._libhair import Choice as Choice
from ._libhair import DeepOpacityMapSettings as DeepOpacityMapSettings
from ._libhair import DeepShadowMapSettings as DeepShadowMapSettings
from ._libhair import DensityClusteringSettings as DensityClusteringSettings
from ._libhair import DensityGrid as DensityGrid
from ._libhair import DensityGridSettings as DensityGridSettings
from ._libhair import DensityMap as DensityMap
from ._libhair import DensityMapSettings as DensityMapSettings
from ._libhair import DetailSettings as DetailSettings
from ._libhair import DistanceField as DistanceField
from ._libhair import Error as Error
from ._libhair import ErrorFigures as ErrorFigures
from ._libhair import Fibre as Fibre
from ._libhair import Figure as Figure
from ._libhair import FrameSettings as FrameSettings
from ._libhair import Groom as Groom
from ._libhair import GroomDetail as GroomDetail
from ._libhair import GuideSettings as GuideSettings
from ._libhair import HeadFit as HeadFit
from ._libhair import KajiyaKaySettings as KajiyaKaySettings
from ._libhair import LevelOfDetail as LevelOfDetail
from ._libhair import Light as Light
from ._libhair import LoadedGroom as LoadedGroom
from ._libhair import MachineCosts as MachineCosts
from ._libhair import Mesh as Mesh
from ._libhair import MeshCollider as MeshCollider
from ._libhair import Motion as Motion
from ._libhair import OpacityMapSettings as OpacityMapSettings
from ._libhair import Parting as Parting
from ._libhair import PilotSettings as PilotSettings
from ._libhair import Pose as Pose
from ._libhair import RepulsionSettings as RepulsionSettings
from ._libhair import SamplePoints as SamplePoints
from ._libhair import ShadowMapSettings as ShadowMapSettings
from ._libhair import ShadowMethod as ShadowMethod
from ._libhair import Simulation as Simulation
from ._libhair import StrandFile as StrandFile
from ._libhair import StrandSequenceWriter as StrandSequenceWriter
from ._libhair import Strands as Strands
from ._libhair import StyleSettings as StyleSettings
from ._libhair import Transform as Transform
from ._libhair import Trial as Trial
from ._libhair import Truth as Truth
from ._libhair import Wind as Wind
from ._libhair import WispSettings as WispSettings
from ._libhair import bind_groom as bind_groom
from ._libhair import builtin_head as builtin_head
from ._libhair import calibrate as calibrate
from ._libhair import candidates as candidates
from ._libhair import choose_points as choose_points
from ._libhair import choose_shadow as choose_shadow
from ._libhair import encode_srgb as encode_srgb
from ._libhair import error_figures as error_figures
from ._libhair import fit_head as fit_head
from ._libhair import fit_map as fit_map
from ._libhair import groom_at as groom_at
from ._libhair import hair_mesh_groom as hair_mesh_groom
from ._libhair import has_hair_mesh as has_hair_mesh
from ._libhair import head_pixels as head_pixels
from ._libhair import level_for as level_for
from ._libhair import load_groom as load_groom
from ._libhair import make_groom as make_groom
from ._libhair import place_head as place_head
from ._libhair import read_obj as read_obj
from ._libhair import read_strands as read_strands
from ._libhair import run_trials as run_trials
from ._libhair import shade as shade
from ._libhair import shadow as shadow
from ._libhair import style_settings as style_settings
from ._libhair import thread_count as thread_count
from ._libhair import thread_limit as thread_limit
from ._libhair import trial_front as trial_front
from ._libhair import truth as truth
from ._libhair import write_strands as write_strands

__all__ = [
    "BindSettings",
    "Candidate",
    "Choice",
    "DeepOpacityMapSettings",
    "DeepShadowMapSettings",
    "DensityClusteringSettings",
    "DensityGrid",
    "DensityGridSettings",
    "DensityMap",
    "DensityMapSettings",
    "DetailSettings",
    "DistanceField",
    "Error",
    "ErrorFigures",
    "Fibre",
    "Figure",
    "FrameSettings",
    "Groom",
    "GroomDetail",
    "GuideSettings",
    "HeadFit",
    "KajiyaKaySettings",
    "LevelOfDetail",
    "Light",
    "LoadedGroom",
    "MachineCosts",
    "Mesh",
    "MeshCollider",
    "Motion",
    "OpacityMapSettings",
    "Parting",
    "PilotSettings",
    "Pose",
    "RepulsionSettings",
    "SamplePoints",
    "ShadowMapSettings",
    "ShadowMethod",
    "Simulation",
    "StrandFile",
    "StrandSequenceWriter",
    "Strands",
    "StyleSettings",
    "Transform",
    "Trial",
    "Truth",
    "Wind",
    "WispSettings",
    "bind_groom",
    "builtin_head",
    "calibrate",
    "candidates",
    "choose_points",
    "choose_shadow",
    "encode_srgb",
    "error_figures",
    "fit_head",
    "fit_map",
    "groom_at",
    "hair_mesh_groom",
    "has_hair_mesh",
    "head_pixels",
    "level_for",
    "load_groom",
    "make_groom",
    "place_head",
    "read_obj",
    "read_strands",
    "run_trials",
    "shade",
    "shadow",
    "style_settings",
    "thread_count",
    "thread_limit",
    "trial_front",
    "truth",
    "write_strands",
]
